#pragma once

#include "common/geometry/pose.h"
#include "modules/mapper/core/movement/direction_times.h"
#include "modules/mapper/core/registration/prepared_scan.h"

namespace scanway {

/// How the robot moved while it took a sweep: once, by so much, after so long.
struct RobotMovement {
  bool known = false;  ///< The sweep says when each point was measured, and enough of it was seen before and after.
  bool moved = false;
  double shift_m = 0.0;  ///< Of the sensor.
  double turn_rad = 0.0;
  double shift_sigma_m = 0.0, turn_sigma_rad = 0.0;
  double after_s = 0.0;  ///< Since the sweep's begin.
};

/// From a sweep that is registered to another: its surfaces lie on the target's as if the robot had stood in two
/// places, one before and one after some moment of the sweep, which is chosen so that they lie best (a change point by
/// likelihood; Hinkley, Inference about the change-point in a sequence of random variables, Biometrika 57(1), 1970).
RobotMovement robot_movement(const DirectionTimes& times, const PreparedScan::Data& sweep,
                             const PreparedScan::Data& target, const Pose& T_target_sweep);

}  // namespace scanway
