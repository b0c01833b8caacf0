#pragma once

#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "common/bytes/frame_finder.h"

namespace scanway::xsens {

/// A message whose frame is whole, and whose content is not what its identifier promises. what() says what.
class BadMessage : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Message identifiers (MID). The acknowledgement of a request has the next one.
enum Mid : std::uint8_t {
  kReqDeviceId = 0x00,
  kDeviceId = 0x01,
  kInitResults = 0x03,
  kSetPeriod = 0x04,
  kReqConfiguration = 0x0C,
  kConfiguration = 0x0D,
  kGoToMeasurement = 0x10,
  kReqFirmware = 0x12,
  kFirmware = 0x13,
  kSetBaudrate = 0x18,
  kReqProductCode = 0x1C,
  kProductCode = 0x1D,
  kGoToConfig = 0x30,
  kMtData = 0x32,
  kMtData2 = 0x36,
  kWakeUp = 0x3E,
  kWakeUpAck = 0x3F,
  kReset = 0x40,
  kError = 0x42,
  kSetOutputConfiguration = 0xC0,
  kOutputConfiguration = 0xC1,
  kSetOutputMode = 0xD0,
  kSetOutputSettings = 0xD2,
  kSetOutputSkipFactor = 0xD4,
};

/// One message, out of its frame.
struct Message {
  std::uint8_t bus_id = 0xFF;
  std::uint8_t mid = 0;
  std::vector<std::uint8_t> data;
};

/// Every frame begins with this byte.
constexpr std::uint8_t kPreamble = 0xFA;

/// The rule for a FrameFinder: what begins at bytes[0].
FrameProbe probe_frame(std::span<const std::uint8_t> bytes);

inline FrameFinder make_frame_finder() { return FrameFinder(probe_frame, kPreamble); }

/// The message in a whole frame.
Message open_frame(std::span<const std::uint8_t> frame);

/// A message in its frame, ready to be sent.
std::vector<std::uint8_t> make_frame(std::uint8_t mid, std::span<const std::uint8_t> data = {});

/// "MTData2", "GoToConfigAck"; "message 0x77" for those that no sheet lists.
std::string message_name(std::uint8_t mid);

/// Of an Error message: "period invalid"; "unlisted error 99" for codes that no sheet lists.
std::string error_name(unsigned code);

}  // namespace scanway::xsens
