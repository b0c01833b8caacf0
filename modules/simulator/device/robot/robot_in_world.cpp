#include "modules/simulator/device/robot/robot_in_world.h"

#include <algorithm>

#include "common/math/repeatable.h"

namespace scanway::simulator {
namespace {

constexpr std::uint8_t kPanId = 11, kTiltId = 12;
constexpr int kTrackerBaud = 115200, kBaseBaud = 38400;
constexpr int kMostFramesATurn = 64;

ModuleConfig module_config(std::uint8_t id, double reach, double max_speed) {
  ModuleConfig config;
  config.id = id;
  config.low = -reach;
  config.high = reach;
  config.max_speed = max_speed;
  config.referenced = true;
  return config;
}

/// The robot's motion between two moments of its wheels, in its frame at the first.
Pose motion_between(const WheelMotion& from, const WheelMotion& to) {
  const double dx = (to.x_mm - from.x_mm) * 1e-3, dy = (to.y_mm - from.y_mm) * 1e-3;
  const double c = repeatable::cos(from.heading), s = repeatable::sin(from.heading);
  Pose motion = Pose::Identity();
  motion.translation() = Eigen::Vector3d(c * dx + s * dy, c * dy - s * dx, 0.0);
  motion.linear() = rotation_about_z(to.heading - from.heading);
  return motion;
}

}  // namespace

RobotInWorld::RobotInWorld(const World& world, const Robot& robot, const Stand& stand, std::uint64_t seed, int thin,
                           const DeviceEnds& ends)
    : world_(world),
      robot_(robot),
      seed_(seed),
      X_world_start_(stand.X_world_base),
      laser_(world, robot, seed, thin),
      pan_(module_config(kPanId, radians(420), radians(360))),
      tilt_(module_config(kTiltId, radians(120), 4.1)),
      lms_([this](const MirrorTurn& turn) { return laser_.look(turn, pan_, tilt_); }),
      tracker_([this](std::int64_t sample, Utime) { return sense(sample); }),
      lms_end_(ends.lms_port),
      can_(serve_can(ends.can)),
      tracker_end_(ends.tracker),
      base_end_(ends.base) {
  put(stand.X_world_base);
}

void RobotInWorld::put(const Pose& X_world_base) {
  X_world_base_ = X_world_base;
  laser_.put_robot(X_world_base);
  orientation_ = std::make_unique<Tracker>(robot_.tracker, X_world_base, seed_);
}

void RobotInWorld::tell_host_time(double speed) {
  lms_.tell_host_time(speed);
  tracker_.tell_host_time(speed);
}

void RobotInWorld::run(Utime now, int wait_ms) {
  run_pan_tilt(now, wait_ms);
  run_base(now);
  follow_wheels();
  run_lms(now);
  run_tracker(now);
}

void RobotInWorld::run_lms(Utime now) {
  const TcpEnd::Heard heard = lms_end_.hear();
  if (heard.new_host || !lms_end_.connected()) lms_.hang_up();
  if (const std::string answers = lms_.receive(heard.bytes, now); !answers.empty()) lms_end_.say(answers);
  for (const std::string& frame : lms_.tick(now)) lms_end_.say(frame);
}

void RobotInWorld::run_pan_tilt(Utime now, int wait_ms) {
  for (int i = 0; i < kMostFramesATurn; ++i) {
    const auto received = can_->receive(i == 0 ? wait_ms : 0);
    if (!received) break;
    if (!received->frame) continue;
    pan_.receive(*received->frame, now);
    tilt_.receive(*received->frame, now);
  }
  for (PanTiltModule* module : {&pan_, &tilt_}) {
    module->tick(now);
    for (const CanFrame& frame : module->take_frames()) can_->send(frame);
  }
}

void RobotInWorld::run_tracker(Utime now) {
  // At another rate than its own it hears nothing, and the host hears nothing of it.
  const auto bytes = tracker_end_.hear();
  const bool right_rate = tracker_end_.baud() == kTrackerBaud;
  const XbusBytes answers = tracker_.receive(right_rate ? bytes : XbusBytes(), now);
  const XbusBytes more = tracker_.tick(now);
  if (!right_rate) return;
  tracker_end_.say(answers);
  tracker_end_.say(more);
}

void RobotInWorld::run_base(Utime now) {
  const auto bytes = base_end_.hear();
  const bool right_rate = base_end_.baud() == kBaseBaud;
  const BaseBytes answers = base_.receive(right_rate ? bytes : BaseBytes(), now);
  const BaseBytes more = base_.tick(now);
  if (!right_rate) return;
  base_end_.say(answers);
  base_end_.say(more);
}

void RobotInWorld::follow_wheels() {
  const WheelMotion& motion = base_.motion();
  const bool stands = motion.speed_mm_s == 0.0 && motion.turn_rate_rad_s == 0.0;
  if (stands && stands_) return;
  put(X_world_start_ * motion_between(at_start_, motion));
  stands_ = stands;
  if (!stands) return;
  const Eigen::Vector3d ahead = X_world_base_.linear().col(0), p = X_world_base_.translation();
  const Stand stand = stand_at(world_, robot_, {p.x(), p.y(), repeatable::atan2(ahead.y(), ahead.x())});
  problem_ = stand.problem;
  if (problem_.empty()) put(stand.X_world_base);
  X_world_start_ = X_world_base_;
  at_start_ = motion;
}

TrackerSample RobotInWorld::sense(std::int64_t sample) const {
  const TrackerReading reading = orientation_->read(static_cast<int>(sample & 0x7FFFFFFF));
  const Eigen::Matrix3d R_base_tracker = robot_.tracker.R_base_tracker();
  const Eigen::Vector3d turning(0.0, 0.0, base_.motion().turn_rate_rad_s);
  TrackerSample sensed;
  sensed.q_world_sensor = (reading.R_world_base * Eigen::Quaterniond(R_base_tracker)).normalized();
  sensed.acceleration = R_base_tracker.transpose() * reading.accel;
  sensed.rate_of_turn = R_base_tracker.transpose() * (reading.gyro + turning);
  sensed.magnetic_field = sensed.q_world_sensor.conjugate() * Eigen::Vector3d(0.0, 1.0, 0.0);
  return sensed;
}

}  // namespace scanway::simulator
