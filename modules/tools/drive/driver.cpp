#include "modules/tools/drive/driver.h"

#include <fmt/format.h>

#include <chrono>
#include <cmath>

#include "bot_core/pose_t.hpp"
#include "common/bus/channels.h"
#include "common/bus/lcm_url.h"
#include "common/clock/host_time.h"
#include "common/files/input_error.h"
#include "common/math/angle.h"
#include "common/messages/codec.h"
#include "common/messages/goal_message.h"
#include "common/messages/pose_message.h"
#include "scanway/base_command_t.hpp"

namespace scanway::tools {
namespace {

constexpr auto kWait = std::chrono::milliseconds(5);
constexpr auto kListenForTwins = std::chrono::milliseconds(1500);
constexpr SteadyTime kSecond = 1'000'000;
constexpr SteadyTime kBasePatience = 5 * kSecond;
/// A mapper or planner at work on a large sweep says nothing else meanwhile.
constexpr SteadyTime kMapPatience = 120 * kSecond;
constexpr SteadyTime kCommandPeriod = 20'000;     // Commands run out after 150 ms (docs/devices.md).
constexpr SteadyTime kOdometryAge = kSecond / 4;  // Older, and the robot is told to stand.
constexpr SteadyTime kSilence = 10 * kSecond;
constexpr SteadyTime kStuck = 5 * kSecond;
constexpr SteadyTime kStandsWithin = 3 * kSecond;

/// Notices that a robot stays where it is.
class Progress {
 public:
  explicit Progress(const Pose& X) : X_(X) {}
  bool stuck(const Pose& X) {
    const Pose step = X_.inverse() * X;
    if (step.translation().norm() > 0.01 || rotation_angle(step.linear()) > radians(2)) {
      X_ = X;
      moved_ = steady_now();
    }
    return steady_now() - moved_ > kStuck;
  }

 private:
  Pose X_;
  SteadyTime moved_ = steady_now();
};

std::vector<Eigen::Vector2d> points_of(const path_t& path) {
  std::vector<Eigen::Vector2d> points;
  for (std::size_t i = 0; i < path.pose_x_m.size(); ++i) points.emplace_back(path.pose_x_m[i], path.pose_y_m[i]);
  return points;
}

}  // namespace

Driver::Driver(const std::string& url) : lcm_(lcm_url(url)), bus_(lcm_, this_process("driver")) {
  hear<map_state_t>(channel::kMapState, [this](const map_state_t& state) { map_ = state; });
  hear<bot_core::pose_t>(channel::kPose, [this](const bot_core::pose_t& pose) { X_map_base_ = pose_of(pose); });
  hear<bot_core::pose_t>(channel::kOdometry, [this](const bot_core::pose_t& pose) {
    X_odometry_base_ = pose_of(pose);
    moves_ = pose.vel[0] != 0.0 || pose.rotation_rate[2] != 0.0;
    odometry_heard_ = steady_now();
  });
  bus_.subscribe(channel::kPath.name, [this](const BusMessage& message) {
    paths_.take(message.bytes, [this](const path_t& path, const Object&) { path_ = path; });
  });
  bus_.start();
  bus_.refuse_twins(kListenForTwins);
}

template <class T>
void Driver::hear(const Channel& channel, const std::function<void(const T&)>& take) {
  bus_.subscribe(channel.name, [take](const BusMessage& message) {
    try {
      take(decode<T>(message.bytes));
    } catch (const BadMessage&) {
      // The bus counts it.
    }
  });
}

void Driver::wait_for(const std::function<bool()>& ready, SteadyTime patience, const std::string& otherwise) {
  for (const SteadyTime end = steady_now() + patience; !ready();) {
    if (steady_now() > end) throw InputError(otherwise);
    bus_.dispatch(kWait);
  }
}

bool Driver::is_answer(const path_t& path, const Eigen::Vector2d& goal_m) const {
  return path.mode != "point" && path.provisional == 0 && path.map_up_to_date != 0 && path.goal[0] == goal_m.x() &&
         path.goal[1] == goal_m.y() && path.map_version == map_->map_version;
}

path_t Driver::ask_for_path(const Eigen::Vector2d& goal_m) {
  wait_for([this] { return odometry_heard_ > 0; }, kBasePatience, "no scanway-base is heard on this bus: start it");
  map_.reset();
  wait_for([this] { return map_ && map_->settled && map_->map_version > 0 && X_map_base_; }, kMapPatience,
           "there is no map on this bus that the robot has a place in: start scanway-mapper and take a sweep");
  bus_.publish(channel::kGoal.name, encode(goal_message(host_now(), goal_m)), 0);
  wait_for([&] { return path_ && is_answer(*path_, goal_m); }, kMapPatience,
           "no path for this goal is heard on this bus: start scanway-planner");
  X_map_odometry_ = *X_map_base_ * X_odometry_base_.inverse();
  return *path_;
}

void Driver::tell_base(const Motion& motion) {
  const base_command_t command{host_now(), motion.forward_m_s, motion.turn_rad_s};
  bus_.publish(channel::kBaseCommand.name, encode(command), 0);
}

std::string Driver::follow(const path_t& path, double speed_m_s) {
  FollowerLimits limits;
  limits.speed_m_s = speed_m_s;
  PathFollower follower(points_of(path), limits);
  Progress progress(X_odometry_base_);
  std::string trouble;
  for (SteadyTime next = 0; trouble.empty(); bus_.dispatch(kWait)) {
    if (steady_now() < next) continue;
    next = steady_now() + kCommandPeriod;
    const SteadyTime age = steady_now() - odometry_heard_;
    if (age > kSilence) trouble = "the base has fallen silent";
    if (age > kOdometryAge) {
      tell_base({});
      continue;
    }
    const Pose X_map_base = X_map_odometry_ * X_odometry_base_;
    const auto motion = follower.next(X_map_base.translation().head<2>(), heading_of(X_map_base.linear()));
    if (!motion) break;
    tell_base(*motion);
    if (progress.stuck(X_odometry_base_)) trouble = "it does not move, though it is told to";
  }
  stand();
  if (trouble.empty() && follower.lost()) {
    trouble = fmt::format("it is {:.2f} m off its path", follower.off_path_m());
  }
  return trouble;
}

void Driver::stand() {
  const SteadyTime begun = steady_now();
  for (SteadyTime stood = begun; steady_now() - begun < kStandsWithin; bus_.dispatch(kWait)) {
    tell_base({});
    if (moves_) stood = steady_now();
    if (steady_now() - stood > kSecond / 5) return;
  }
}

}  // namespace scanway::tools
