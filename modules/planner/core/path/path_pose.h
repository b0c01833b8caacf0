#pragma once

namespace scanway::planning {

/// A pose of the robot on a path, in `map`.
struct PathPose {
  double x_m = 0.0;
  double y_m = 0.0;
  double heading = 0.0;    ///< Radians, counter-clockwise from x.
  double time_s = 0.0;     ///< After the start.
  double speed_m_s = 0.0;  ///< Negative: backwards. From pose to pose it changes evenly.
  bool operator==(const PathPose&) const = default;
};

}  // namespace scanway::planning
