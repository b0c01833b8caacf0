#pragma once

#include <optional>
#include <vector>

#include "modules/mapper/core/assembly/scan_line.h"

namespace scanway {

/// How still the robot stood, as the tracker saw it.
struct Steadiness {
  std::size_t orientations = 0;
  std::optional<Eigen::Quaterniond> R_world_base;  ///< Their mean; absent without any.
  double largest_turn_rad = 0.0;                   ///< Between the mean of the first second and that of any later one.
  bool moved = false;                              ///< That is more than kTurnIsMovement_rad.
  Utime moved_at = 0;                              ///< When such a second began first.
};

/// The tracker's own noise is a tenth of this a reading, and far less in the mean of a second.
constexpr double kTurnIsMovement_rad = 0.0035;  // 0.2 degrees; 3.5 cm at 10 m.

/// Of the orientations from `begin` to `end`, which are in the order of their times.
Steadiness steadiness_of(const std::vector<Orientation>& orientations, Utime begin, Utime end);

}  // namespace scanway
