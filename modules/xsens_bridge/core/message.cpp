#include "modules/xsens_bridge/core/message.h"

#include <cstdio>
#include <numeric>

#include "common/bytes/big_endian.h"

namespace scanway::xsens {
namespace {

constexpr std::uint8_t kMaster = 0xFF;          // Bus identifier of a single tracker.
constexpr std::uint8_t kExtendedLength = 0xFF;  // In the place of the length: two bytes of length follow.
constexpr std::size_t kShortHeader = 4;
constexpr std::size_t kLongHeader = 6;
constexpr std::size_t kMinExtended = 255;
constexpr std::size_t kMaxExtended = 2048;

struct Name {
  unsigned number;
  const char* name;
};

constexpr Name kMessages[] = {
    {0x00, "ReqDID"},
    {0x01, "DeviceID"},
    {0x03, "InitMTResults"},
    {0x04, "SetPeriod"},
    {0x05, "SetPeriodAck"},
    {0x0A, "ReqDataLength"},
    {0x0B, "DataLength"},
    {0x0C, "ReqConfiguration"},
    {0x0D, "Configuration"},
    {0x0E, "RestoreFactoryDef"},
    {0x0F, "RestoreFactoryDefAck"},
    {0x10, "GoToMeasurement"},
    {0x11, "GoToMeasurementAck"},
    {0x12, "ReqFWRev"},
    {0x13, "FirmwareRev"},
    {0x18, "SetBaudrate"},
    {0x19, "SetBaudrateAck"},
    {0x1C, "ReqProductCode"},
    {0x1D, "ProductCode"},
    {0x30, "GoToConfig"},
    {0x31, "GoToConfigAck"},
    {0x32, "MTData"},
    {0x34, "ReqData"},
    {0x36, "MTData2"},
    {0x3E, "WakeUp"},
    {0x3F, "WakeUpAck"},
    {0x40, "Reset"},
    {0x41, "ResetAck"},
    {0x42, "Error"},
    {0x8E, "SetStringOutputType"},
    {0x8F, "SetStringOutputTypeAck"},
    {0x91, "EncryptedSettings"},
    {0xA4, "ResetOrientation"},
    {0xA5, "ResetOrientationAck"},
    {0xC0, "SetOutputConfiguration"},
    {0xC1, "OutputConfiguration"},
    {0xD0, "SetOutputMode"},
    {0xD1, "SetOutputModeAck"},
    {0xD2, "SetOutputSettings"},
    {0xD3, "SetOutputSettingsAck"},
    {0xD4, "SetOutputSkipFactor"},
    {0xD5, "SetOutputSkipFactorAck"},
    {0xDA, "SetErrorMode"},
    {0xDB, "SetErrorModeAck"},
};

constexpr Name kErrors[] = {
    {1, "no bus communication"},
    {2, "bus not ready"},
    {3, "period invalid"},
    {4, "message invalid or not implemented"},
    {16, "bus initialisation failed"},
    {17, "bus initialisation failed"},
    {18, "bus initialisation failed"},
    {20, "setting the bus identifier failed"},
    {21, "setting the bus identifier failed"},
    {24, "measurement failed"},
    {25, "measurement failed"},
    {26, "measurement failed"},
    {27, "measurement failed"},
    {28, "measurement failed"},
    {29, "measurement failed"},
    {30, "timer overflow"},
    {32, "baud rate invalid"},
    {33, "parameter invalid"},
    {35, "transmit buffer full"},
    {36, "transmit buffer full"},
    {37, "wireless failure"},
    {40, "device error"},
    {41, "data overflow (the output rate is too high for the baud rate)"},
    {42, "buffer overflow"},
    {43, "trigger error"},
    {44, "sample order error"},
    {45, "power dip"},
    {46, "current limit"},
    {47, "temperature out of range"},
    {48, "battery low"},
    {49, "filter profile not available"},
    {50, "stored settings invalid"},
    {51, "control denied"},
};

const char* find_name(std::span<const Name> names, unsigned number) {
  for (const Name& known : names) {
    if (known.number == number) return known.name;
  }
  return nullptr;
}

/// Lower byte of the sum of all bytes but the preamble: 0 for a whole frame.
std::uint8_t sum_of(std::span<const std::uint8_t> frame) {
  return static_cast<std::uint8_t>(std::accumulate(frame.begin() + 1, frame.end(), 0U));
}

bool is_extended(std::span<const std::uint8_t> frame) { return frame[3] == kExtendedLength; }

}  // namespace

FrameProbe probe_frame(std::span<const std::uint8_t> bytes) {
  if (bytes[0] != kPreamble || (bytes.size() > 1 && bytes[1] != kMaster)) return FrameProbe::none();
  if (bytes.size() < kShortHeader) return FrameProbe::unfinished();
  std::size_t whole = kShortHeader + bytes[3] + 1;
  if (is_extended(bytes)) {
    if (bytes.size() < kLongHeader) return FrameProbe::unfinished();
    const std::size_t length = BigEndianReader(bytes.subspan(kShortHeader)).u16();
    if (length < kMinExtended || length > kMaxExtended) return FrameProbe::none();
    whole = kLongHeader + length + 1;
  }
  if (bytes.size() < whole) return FrameProbe::unfinished();
  if (sum_of(bytes.first(whole)) != 0) return FrameProbe::broken("wrong checksum");
  return FrameProbe::whole(whole);
}

Message open_frame(std::span<const std::uint8_t> frame) {
  const std::size_t header = is_extended(frame) ? kLongHeader : kShortHeader;
  return {frame[1], frame[2], {frame.begin() + static_cast<std::ptrdiff_t>(header), frame.end() - 1}};
}

std::vector<std::uint8_t> make_frame(std::uint8_t mid, std::span<const std::uint8_t> data) {
  std::vector<std::uint8_t> frame{kPreamble, kMaster, mid};
  if (data.size() < kMinExtended) {
    append_big_endian(frame, data.size(), 1);
  } else {
    frame.push_back(kExtendedLength);
    append_big_endian(frame, data.size(), 2);
  }
  frame.insert(frame.end(), data.begin(), data.end());
  frame.push_back(static_cast<std::uint8_t>(-sum_of(frame)));
  return frame;
}

std::string message_name(std::uint8_t mid) {
  if (const char* name = find_name(kMessages, mid)) return name;
  char text[16];
  std::snprintf(text, sizeof text, "message 0x%02X", mid);
  return text;
}

std::string error_name(unsigned code) {
  if (const char* name = find_name(kErrors, code)) return name;
  return "unlisted error " + std::to_string(code);
}

}  // namespace scanway::xsens
