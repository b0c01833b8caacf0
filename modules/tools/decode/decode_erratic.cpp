#include "modules/tools/decode/decode_erratic.h"

#include <iostream>
#include <stdexcept>

#include "common/files/read_file.h"
#include "modules/base_bridge/core/command.h"
#include "modules/base_bridge/core/packet.h"
#include "modules/base_bridge/core/report.h"
#include "modules/tools/decode/decode_stream.h"

namespace scanway::tools {
namespace {

using Json = nlohmann::ordered_json;

std::string hex_of(std::uint8_t byte) {
  constexpr std::string_view digits = "0123456789ABCDEF";
  return {'0', 'x', digits[byte >> 4], digits[byte & 15]};
}

struct LineOfReport {
  Json operator()(const erratic::MotorReport& report) const {
    return {{"type", "motor"},
            {"packet", hex_of(report.type)},
            {"raw_x_12bit", report.x_counts},
            {"raw_y_12bit", report.y_counts},
            {"heading_counts", report.heading_counts},
            {"heading_rad", report.heading_rad()},
            {"left_raw", report.left_counts},
            {"right_raw", report.right_counts},
            {"left_mm_s", report.left_mm_s()},
            {"right_mm_s", report.right_mm_s()},
            {"vx_m_s", report.speed_m_s()},
            {"omega_rad_s", report.turn_rate_rad_s()},
            {"battery_V", report.battery_V},
            {"left_stall", report.left_stall ? 1 : 0},
            {"right_stall", report.right_stall ? 1 : 0},
            {"control_counts", report.control_counts},
            {"control_rad", report.control_rad()}};
  }
  Json operator()(const erratic::ConfigurationReport& report) const {
    return {{"type", "configuration"},
            {"name", report.name},
            {"robot_type", report.type},
            {"subtype", report.subtype},
            {"mm_per_count", report.metres_per_count() * 1000.0}};
  }
  Json operator()(const erratic::AnalogReport& report) const {
    Json line = {{"type", "analog"}, {"volts", report.volts}, {"digital", Json::array()}};
    for (const bool input : report.digital) line["digital"].push_back(input ? 1 : 0);
    return line;
  }
  Json operator()(const erratic::SonarReport& report) const {
    Json line = {{"type", "sonar"}, {"ranges_m", Json::object()}};
    for (const auto& range : report.ranges) line["ranges_m"][std::to_string(range.channel)] = range.range_m;
    return line;
  }
  Json operator()(const erratic::TextReport& report) const { return {{"type", "text"}, {"text", report.text}}; }
  Json operator()(const erratic::OtherReport& report) const {
    Json line = {{"type", report.type == 0x90 ? "encoder" : "other"}, {"packet", hex_of(report.type)}};
    line["bytes"] = report.content;
    return line;
  }
  Json operator()(const erratic::MalformedReport& report) const { throw std::invalid_argument(report.reason); }
};

Json line_of_command(const erratic::ReadCommand& command) {
  Json line = {{"type", std::string(erratic::name_of(command.command))}, {"direction", "host to robot"}};
  if (command.value) line["value"] = *command.value;
  if (command.command == erratic::Command::wheel_vel && command.content.size() == 2) {
    line["right_mm_s"] = 20 * static_cast<std::int8_t>(command.content[0]);
    line["left_mm_s"] = 20 * static_cast<std::int8_t>(command.content[1]);
  } else if (command.command == erratic::Command::servo_pos && command.content.size() == 3) {
    line["servo"] = command.content[0];
    line["counts"] = command.content[1] | command.content[2] << 8;
  } else if (!command.content.empty()) {
    line["bytes"] = command.content;
  }
  return line;
}

/// Two numbers mean one thing from the host and another from the robot (rot_vel and text, wheel_vel and configuration);
/// only commands have the form of commands.
Json line_of_packet(std::span<const std::uint8_t> packet) {
  const erratic::Bytes payload = erratic::payload_of(packet);
  if (const auto command = erratic::read_command(payload)) return line_of_command(*command);
  return std::visit(LineOfReport(), erratic::read_report(payload));
}

}  // namespace

void decode_erratic(std::span<const std::uint8_t> bytes, std::ostream& out) {
  FrameFinder finder = erratic::make_packet_finder();
  decode_stream(finder, bytes, out, line_of_packet);
}

int run_decode_erratic(const std::string& file) {
  const std::string bytes = read_file(file);
  decode_erratic(std::span(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()), std::cout);
  return 0;
}

}  // namespace scanway::tools
