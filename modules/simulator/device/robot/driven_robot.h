#pragma once

#include <cstdint>
#include <string>

#include "common/geometry/pose.h"
#include "common/robot/robot.h"
#include "modules/simulator/core/stand.h"
#include "modules/simulator/core/truth/truth_grid.h"
#include "modules/simulator/core/world/world.h"
#include "modules/simulator/device/base/base_emulator.h"
#include "modules/simulator/device/robot/wheel_slip.h"

namespace scanway::simulator {

/// Where its wheels take the robot: they slip, and where it would not fit it does not go. On its way it keeps the slope
/// of the last place, and stands on the ground where it comes to a stand.
class DrivenRobot {
 public:
  /// `world` and `robot` must outlive this.
  DrivenRobot(const World& world, const Robot& robot, const Pose& X_world_base, std::uint64_t seed);

  void set_slip(double share) { slip_.set_share(share); }
  /// The wheels' motion so far. False: the robot is where it was.
  bool follow(const WheelMotion& motion);
  /// The base has been switched on anew, and counts from zero.
  void count_anew() { followed_ = {}; }
  /// Whether it is held where it is, told to drive so: as by a wall in its way.
  bool is_held(double speed_mm_s, double turn_rate_rad_s);

  bool stands() const { return stands_; }
  const Pose& X_world_base() const { return X_world_base_; }
  /// What it would be in if it went on, ends the sentence "the robot is held: it would stand ..."; empty: nothing.
  const std::string& obstacle() const { return obstacle_; }

 private:
  std::string problem_at(const Pose& X_world_base);
  void settle();

  const World& world_;
  const Robot& robot_;
  Pose X_world_base_;
  WheelMotion followed_;
  bool stands_ = true;
  WheelSlip slip_;
  std::string obstacle_;
  TruthGrid around_;  // The world about the robot.
  Rectangle known_{{0, 0}, {0, 0}};
};

}  // namespace scanway::simulator
