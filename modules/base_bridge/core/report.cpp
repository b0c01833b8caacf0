#include "modules/base_bridge/core/report.h"

#include <algorithm>

#include "common/math/repeatable.h"

namespace scanway::erratic {
namespace {

constexpr std::size_t kMotorPayload = 18;
constexpr double kWheelMillimetresPerCount = 1.20482;

std::uint16_t u16(Bytes bytes, std::size_t at) { return static_cast<std::uint16_t>(bytes[at] | bytes[at + 1] << 8); }
std::int16_t i16(Bytes bytes, std::size_t at) { return static_cast<std::int16_t>(u16(bytes, at)); }

MalformedReport too_short(const char* what, Bytes payload) {
  return {std::string(what) + " with a payload of " + std::to_string(payload.size()) + " bytes"};
}

Report read_motor(Bytes payload) {
  if (payload.size() < kMotorPayload) return too_short("motor packet", payload);
  MotorReport report;
  report.type = payload[0];
  report.x_counts = u16(payload, 1) & 0x0FFF;  // What the upper 12 bits of the 24 hold is not known.
  report.y_counts = u16(payload, 4) & 0x0FFF;
  report.heading_counts = i16(payload, 7);
  report.left_counts = i16(payload, 9);
  report.right_counts = i16(payload, 11);
  report.battery_V = payload[13] / 10.0;
  report.left_stall = (payload[14] & 1) != 0;
  report.right_stall = (payload[15] & 1) != 0;
  report.control_counts = i16(payload, 16);
  return report;
}

/// The string that begins at `at`: up to a zero byte, at most 19 characters.
std::string string_at(Bytes payload, std::size_t at) {
  if (at >= payload.size()) return {};
  const Bytes bytes = payload.subspan(at, std::min<std::size_t>(19, payload.size() - at));
  return {bytes.begin(), std::find(bytes.begin(), bytes.end(), 0)};
}

Report read_configuration(Bytes payload) {
  if (payload.size() < 43) return too_short("configuration packet", payload);
  return ConfigurationReport{string_at(payload, 2), string_at(payload, 22), string_at(payload, 42)};
}

Report read_analog(Bytes payload) {
  if (payload.size() < 2 || payload.size() < 3 + 2 * std::size_t{payload[1]})
    return too_short("analog packet", payload);
  AnalogReport report;
  const std::size_t count = payload[1];
  for (std::size_t i = 0; i < count; ++i) report.volts.push_back(u16(payload, 2 + 2 * i) / 1024.0 * 3.5);
  const std::uint8_t digital = payload[2 + 2 * count];
  for (std::size_t i = 0; i < 4; ++i) report.digital[i] = (digital >> (4 + i) & 1) != 0;
  return report;
}

Report read_sonar(Bytes payload) {
  if (payload.size() < 2 || payload.size() < 2 + 3 * std::size_t{payload[1]}) return too_short("sonar packet", payload);
  SonarReport report;
  for (std::size_t i = 0; i < payload[1]; ++i) {
    const int channel = payload[2 + 3 * i];
    if (channel < 8) report.ranges.push_back({channel, u16(payload, 3 + 3 * i) / 1000.0});
  }
  return report;
}

}  // namespace

double MotorReport::left_mm_s() const { return left_counts * kWheelMillimetresPerCount; }
double MotorReport::right_mm_s() const { return right_counts * kWheelMillimetresPerCount; }
double MotorReport::speed_m_s() const { return (left_mm_s() + right_mm_s()) / 2.0 / 1000.0; }
double MotorReport::turn_rate_rad_s() const { return 0.596 * (right_mm_s() - left_mm_s()) / (2.0 / 0.011); }
double MotorReport::heading_rad() const { return repeatable::kPi * heading_counts / 2048.0; }
double MotorReport::control_rad() const { return control_counts * 0.001534; }

double ConfigurationReport::metres_per_count() const { return subtype == "Rev H" ? 0.930e-3 : 0.780e-3; }

Report read_report(Bytes payload) {
  if (payload.empty()) return MalformedReport{"an empty payload"};
  switch (payload[0]) {
    case 0x80:
    case 0x82:
    case 0x83:
      return read_motor(payload);
    case 0x20:
      return read_configuration(payload);
    case 0x9A:
      return read_analog(payload);
    case 0x9B:
      return read_sonar(payload);
    case 0x15:
      return TextReport{{payload.begin() + 1, payload.end()}};
    default:
      return OtherReport{payload[0], {payload.begin() + 1, payload.end()}};
  }
}

}  // namespace scanway::erratic
