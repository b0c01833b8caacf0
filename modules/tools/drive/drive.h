#pragma once

#include <string>
#include <utility>

namespace scanway::tools {

struct DriveOptions {
  std::pair<double, double> goal_m;  ///< In the map frame.
  double speed_m_s = 0.3;            ///< By the base's own clock.
  std::string lcm_url;               ///< Empty: LCM_DEFAULT_URL, or LCM's default.
};

/// `scanway drive`: gives a GOAL, waits for the planner's path on the newest map, and drives the robot along it by its
/// wheels' odometry, from where its newest sweep was taken. It looks at nothing but the path: what was not there when
/// the map was made is not avoided. Returns 1 when there is no path, or the robot has not arrived, with the reason.
/// Throws InputError.
int run_drive(const DriveOptions& options);

}  // namespace scanway::tools
