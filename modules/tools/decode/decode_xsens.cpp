#include "modules/tools/decode/decode_xsens.h"

#include <iostream>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "common/files/read_file.h"
#include "modules/tools/decode/decode_stream.h"
#include "modules/xsens_bridge/core/message.h"
#include "modules/xsens_bridge/core/mtdata.h"
#include "modules/xsens_bridge/core/mtdata2.h"
#include "modules/xsens_bridge/core/replies.h"

namespace scanway::tools {
namespace {

using Json = nlohmann::ordered_json;

std::string hex_of(std::span<const std::uint8_t> bytes) { return fmt::format("{:02x}", fmt::join(bytes, "")); }

Json json_of(const xsens::Numbers& numbers) { return numbers.size() == 1 ? Json(numbers[0]) : Json(numbers); }
Json json_of(std::uint32_t value) { return value; }
Json json_of(const xsens::BitField& field) { return fmt::format("0x{:0{}X}", field.bits, field.digits); }
Json json_of(const xsens::Bytes& bytes) { return hex_of(bytes); }
Json json_of(const xsens::UtcTime& time) {
  return {{"ns", time.nanosecond}, {"year", time.year},
          {"month", time.month},   {"day", time.day},
          {"hour", time.hour},     {"minute", time.minute},
          {"second", time.second}, {"flags", fmt::format("0x{:02X}", time.flags)}};
}

void add_items(const std::vector<xsens::Item>& items, Json& line) {
  for (const xsens::Item& item : items) {
    const Json value = std::visit([](const auto& known) { return json_of(known); }, item.value);
    if (item.name == "unknown") {
      line["unknown"].push_back({{"id", fmt::format("0x{:04X}", item.id)}, {"hex", value}});
      continue;
    }
    line[std::string(item.name)] = value;
    if (has_frame(item.quantity)) line["frame"] = name_of(item.frame);
    if (item.quantity == xsens::Quantity::sample_counter) line["packet_counter"] = value;
  }
}

Json json_of(const std::vector<xsens::OutputEntry>& entries) {
  Json list = Json::array();
  for (const auto& entry : entries) {
    list.push_back({{"id", fmt::format("0x{:04X}", entry.id)}, {"rate", entry.rate_hz}});
  }
  return list;
}

/// A stream's messages, one after the other: what MTData hold follows from the set-up before them.
class LineMaker {
 public:
  Json operator()(std::span<const std::uint8_t> frame) {
    const xsens::Message message = xsens::open_frame(frame);
    Json line = {{"type", xsens::message_name(message.mid)}};
    try {
      add_content(message, line);
    } catch (const xsens::BadMessage& error) {
      throw xsens::BadMessage(xsens::message_name(message.mid) + ": " + error.what());
    }
    return line;
  }

 private:
  void add_content(const xsens::Message& message, Json& line) {
    if (message.mid == xsens::kMtData2) return add_items(xsens::parse_mtdata2(message.data), line);
    if (message.mid == xsens::kMtData) return add_mtdata(message, line);
    if (message.data.empty()) return;
    switch (message.mid) {
      case xsens::kConfiguration:
        return add_configuration(parse_configuration(message), line);
      case xsens::kSetOutputConfiguration:
      case xsens::kOutputConfiguration:
        line["output_configuration"] = json_of(parse_output_configuration(message));
        return;
      case xsens::kDeviceId:
      case xsens::kInitResults:
        line["device_id"] = fmt::format("0x{:08X}", parse_device_id(message));
        return;
      case xsens::kFirmware:
        return add_firmware(parse_firmware(message), line);
      case xsens::kProductCode:
        line["product_code"] = std::string(message.data.begin(), message.data.end());
        return;
      case xsens::kError:
        return add_error(parse_error(message), line);
      default:
        add_setting(message, line);
    }
  }

  void add_mtdata(const xsens::Message& message, Json& line) {
    auto layout = layout_;
    line["layout_from"] = "set-up";
    if (!layout || length_of(*layout) != message.data.size()) {
      layout = xsens::guess_layout(message.data);
      line["layout_from"] = layout ? "guess" : "nothing";
    }
    if (!layout) {
      line["data_hex"] = hex_of(message.data);
      return;
    }
    line["output_mode"] = fmt::format("0x{:04X}", layout->mode);
    line["output_settings"] = fmt::format("0x{:08X}", layout->settings);
    add_items(xsens::parse_mtdata(message.data, *layout), line);
  }

  void add_configuration(const xsens::Configuration& configuration, Json& line) {
    layout_ = configuration.layout;
    line["master_id"] = fmt::format("0x{:08X}", configuration.master_id);
    line["period"] = configuration.period;
    line["skip_factor"] = configuration.skip_factor;
    line["num_devices"] = configuration.num_devices;
    line["device_id"] = fmt::format("0x{:08X}", configuration.device_id);
    line["mtdata_length"] = configuration.mtdata_length;
    line["output_mode"] = fmt::format("0x{:04X}", configuration.layout.mode);
    line["output_settings"] = fmt::format("0x{:08X}", configuration.layout.settings);
  }

  static void add_firmware(const xsens::Firmware& firmware, Json& line) {
    line["major"] = firmware.major;
    line["minor"] = firmware.minor;
    line["revision"] = firmware.revision;
    if (firmware.build) line["build"] = *firmware.build;
    if (firmware.svn_revision) line["svn_revision"] = *firmware.svn_revision;
  }

  static void add_error(unsigned code, Json& line) {
    line["error_code"] = code;
    line["error"] = xsens::error_name(code);
  }

  /// Messages that set or tell one number; the others' data as they are.
  void add_setting(const xsens::Message& message, Json& line) {
    BigEndianReader reader(message.data);
    if (message.mid == xsens::kSetOutputMode && message.data.size() == 2) {
      set_layout().mode = reader.u16();
      line["output_mode"] = fmt::format("0x{:04X}", layout_->mode);
    } else if (message.mid == xsens::kSetOutputSettings && message.data.size() == 4) {
      set_layout().settings = reader.u32();
      line["output_settings"] = fmt::format("0x{:08X}", layout_->settings);
    } else if ((message.mid | 1) == (xsens::kSetPeriod | 1) && message.data.size() == 2) {
      line["period"] = reader.u16();
    } else {
      line["data_hex"] = hex_of(message.data);
    }
  }

  xsens::OutputLayout& set_layout() {
    if (!layout_) layout_.emplace();
    return *layout_;
  }

  std::optional<xsens::OutputLayout> layout_;
};

}  // namespace

void decode_xsens(std::span<const std::uint8_t> bytes, std::ostream& out) {
  FrameFinder finder = xsens::make_frame_finder();
  decode_stream(finder, bytes, out, LineMaker());
}

int run_decode_xsens(const std::string& file) {
  const std::string bytes = read_file(file);
  decode_xsens(std::span(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()), std::cout);
  return 0;
}

}  // namespace scanway::tools
