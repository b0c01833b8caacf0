#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "modules/xsens_bridge/core/message.h"
#include "modules/xsens_bridge/core/mtdata.h"

namespace scanway::xsens {

/// Configuration (0x0D): what a tracker is set to. Fields that nobody needs are left out.
struct Configuration {
  std::uint32_t master_id = 0;
  std::uint16_t period = 0;  ///< 1/115200 s.
  std::uint16_t skip_factor = 0;
  std::uint16_t num_devices = 0;
  std::uint32_t device_id = 0;
  std::uint16_t mtdata_length = 0;
  OutputLayout layout;
};

/// An entry of an output configuration (0xC0, 0xC1).
struct OutputEntry {
  std::uint16_t id = 0;
  std::uint16_t rate_hz = 0;  ///< 0xFFFF: with every message, or as fast as it gets.

  bool operator==(const OutputEntry&) const = default;
};

struct Firmware {
  int major = 0, minor = 0, revision = 0;
  std::optional<std::uint32_t> build, svn_revision;  ///< Of newer trackers.
};

// Each throws BadMessage when the data are too short for what the message is.
Configuration parse_configuration(const Message& message);
std::vector<OutputEntry> parse_output_configuration(const Message& message);
std::uint32_t parse_device_id(const Message& message);
Firmware parse_firmware(const Message& message);
unsigned parse_error(const Message& message);
/// Without the blanks at its end.
std::string parse_product_code(const Message& message);

std::vector<std::uint8_t> set_output_configuration(const std::vector<OutputEntry>& entries);
/// A message that sets one number of `size` bytes.
std::vector<std::uint8_t> set_number(std::uint8_t mid, std::uint32_t value, int size);

}  // namespace scanway::xsens
