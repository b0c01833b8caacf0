#include "modules/xsens_bridge/core/replies.h"

#include "common/bytes/big_endian.h"

namespace scanway::xsens {
namespace {

/// What `read` makes of the message's data; BadMessage where they are too short for it.
template <class Read>
auto read_all(const Message& message, const Read& read) {
  BigEndianReader reader(message.data);
  try {
    return read(reader);
  } catch (const std::out_of_range&) {
    throw BadMessage(message_name(message.mid) + " of only " + std::to_string(message.data.size()) + " bytes");
  }
}

}  // namespace

Configuration parse_configuration(const Message& message) {
  return read_all(message, [](BigEndianReader& reader) {
    Configuration configuration;
    configuration.master_id = reader.u32();
    configuration.period = reader.u16();
    configuration.skip_factor = reader.u16();
    reader.take(88);  // Synchronisation, date, time and reserved bytes.
    configuration.num_devices = reader.u16();
    configuration.device_id = reader.u32();
    configuration.mtdata_length = reader.u16();
    configuration.layout.mode = reader.u16();
    configuration.layout.settings = reader.u32();
    return configuration;
  });
}

std::vector<OutputEntry> parse_output_configuration(const Message& message) {
  return read_all(message, [](BigEndianReader& reader) {
    std::vector<OutputEntry> entries;
    while (reader.left() > 0) {
      const std::uint16_t id = reader.u16();
      entries.push_back({id, reader.u16()});
    }
    return entries;
  });
}

std::uint32_t parse_device_id(const Message& message) {
  return read_all(message, [](BigEndianReader& reader) { return reader.u32(); });
}

Firmware parse_firmware(const Message& message) {
  return read_all(message, [](BigEndianReader& reader) {
    Firmware firmware;
    firmware.major = reader.u8();
    firmware.minor = reader.u8();
    firmware.revision = reader.u8();
    if (reader.left() == 0) return firmware;
    firmware.build = reader.u32();
    firmware.svn_revision = reader.u32();
    return firmware;
  });
}

unsigned parse_error(const Message& message) {
  return read_all(message, [](BigEndianReader& reader) { return unsigned{reader.u8()}; });
}

std::string parse_product_code(const Message& message) {
  std::string code(message.data.begin(), message.data.end());
  code.erase(code.find_last_not_of(' ') + 1);
  return code;
}

std::vector<std::uint8_t> set_output_configuration(const std::vector<OutputEntry>& entries) {
  std::vector<std::uint8_t> data;
  for (const OutputEntry& entry : entries) {
    append_big_endian(data, entry.id, 2);
    append_big_endian(data, entry.rate_hz, 2);
  }
  return make_frame(kSetOutputConfiguration, data);
}

std::vector<std::uint8_t> set_number(std::uint8_t mid, std::uint32_t value, int size) {
  std::vector<std::uint8_t> data;
  append_big_endian(data, value, size);
  return make_frame(mid, data);
}

}  // namespace scanway::xsens
