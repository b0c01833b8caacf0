#pragma once

#include <functional>
#include <optional>
#include <string>

#include <Eigen/Core>

#include "common/bus/lcm_bus.h"
#include "common/clock/steady_time.h"
#include "common/delivery/live_bus.h"
#include "common/geometry/pose.h"
#include "common/messages/object_input.h"
#include "modules/tools/drive/path_follower.h"
#include "scanway/map_state_t.hpp"
#include "scanway/path_t.hpp"

namespace scanway::tools {

/// Who drives the robot: hears where it is and what the planner says, and tells the base.
class Driver {
 public:
  explicit Driver(const std::string& lcm_url);

  /// The planner's path for the robot's body on the newest map, which may say that there is none. Throws InputError
  /// when no map, no planner or no base is heard.
  path_t ask_for_path(const Eigen::Vector2d& goal_m);
  /// Drives along it, and stands. Returns why it did not arrive, or nothing.
  std::string follow(const path_t& path, double speed_m_s);
  /// In the map, by the wheels since the newest sweep.
  Eigen::Vector2d place() const { return (X_map_odometry_ * X_odometry_base_).translation().head<2>(); }

 private:
  template <class T>
  void hear(const Channel& channel, const std::function<void(const T&)>& take);
  void wait_for(const std::function<bool()>& ready, SteadyTime patience, const std::string& otherwise);
  bool is_answer(const path_t& path, const Eigen::Vector2d& goal_m) const;
  void tell_base(const Motion& motion);
  void stand();

  LcmBus lcm_;
  LiveBus bus_;
  ObjectInput<path_t> paths_;
  std::optional<path_t> path_;
  std::optional<map_state_t> map_;
  std::optional<Pose> X_map_base_;  // Where the newest sweep was taken.
  Pose X_map_odometry_ = Pose::Identity(), X_odometry_base_ = Pose::Identity();
  bool moves_ = false;
  SteadyTime odometry_heard_ = 0;
};

}  // namespace scanway::tools
