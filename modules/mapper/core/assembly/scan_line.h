#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Geometry>

#include "common/time/utime.h"

namespace scanway {

/// A line of the laser as its device counts it: any number of beams, any step, any field of view.
struct ScanLine {
  std::int64_t number = 0;
  Utime utime = 0;               ///< Of its first beam.
  double beam_period_us = 0.0;   ///< From one beam to the next.
  double start_angle_rad = 0.0;  ///< Of its first beam, as the scanner counts: pi / 2 is straight ahead.
  double angle_step_rad = 0.0;
  double range_scale_m = 0.001;  ///< range = count * scale + offset
  double range_offset_m = 0.0;
  double rssi_scale = 1.0;
  double rssi_offset = 0.0;
  std::vector<std::uint16_t> range_counts;  ///< Below kFirstRangeCount: no range.
  std::vector<std::uint16_t> rssi_counts;   ///< Empty, or one a beam.
  std::int32_t missing_beams = 0;           ///< That never came; their counts are kNeverCame.
};

constexpr std::uint16_t kNoReturn = 0;
constexpr std::uint16_t kNeverCame = 15;  // Reserved by the scanner, which sends none of it.
constexpr std::uint16_t kFirstRangeCount = 16;

/// Where the pan-tilt was, radians.
struct PanTiltAngles {
  Utime utime = 0;
  double pan = 0.0, tilt = 0.0;
};

/// What the tracker said.
struct Orientation {
  Utime utime = 0;
  Eigen::Quaterniond R_world_base = Eigen::Quaterniond::Identity();
};

}  // namespace scanway
