#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "modules/base_bridge/core/packet.h"

namespace scanway::erratic {

/// The base's motion (0x80, 0x82 standing, 0x83 moving), as it counts it.
struct MotorReport {
  std::uint8_t type = 0;
  std::uint16_t x_counts = 0, y_counts = 0;  ///< 12 bits; the robot integrates them, from where it was switched on.
  std::int16_t heading_counts = 0;           ///< 4096 a turn, to the left.
  std::int16_t left_counts = 0, right_counts = 0;  ///< Wheel speeds.
  std::int16_t control_counts = 0;                 ///< Set point of the heading.
  double battery_V = 0;
  bool left_stall = false, right_stall = false;

  double left_mm_s() const;
  double right_mm_s() const;
  double speed_m_s() const;        ///< Forward.
  double turn_rate_rad_s() const;  ///< To the left.
  double heading_rad() const;      ///< As counted, not wrapped.
  double control_rad() const;
};

/// 0x20: what the robot is.
struct ConfigurationReport {
  std::string name, type, subtype;

  /// Of the position counts. Revision H differs; whatever is not known counts as E.
  double metres_per_count() const;
};

/// 0x9A
struct AnalogReport {
  std::vector<double> volts;
  std::array<bool, 4> digital{};  ///< Inputs 4 to 7; the floor sensors: true where there is floor.
};

/// 0x9B
struct SonarReport {
  struct Range {
    int channel = 0;  ///< 0 to 7
    double range_m = 0;
  };
  std::vector<Range> ranges;  ///< Not every report holds every channel.
};

/// 0x15: a line for those who write firmware.
struct TextReport {
  std::string text;
};

/// A type that the protocol sheet does not explain.
struct OtherReport {
  std::uint8_t type = 0;
  std::vector<std::uint8_t> content;
};

/// A payload that contradicts its type.
struct MalformedReport {
  std::string reason;
};

using Report =
    std::variant<MotorReport, ConfigurationReport, AnalogReport, SonarReport, TextReport, OtherReport, MalformedReport>;

/// What the robot says in a payload.
Report read_report(Bytes payload);

}  // namespace scanway::erratic
