#include "modules/simulator/device/robot/robot_in_world.h"

#include <algorithm>

#include "common/math/angle.h"

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

}  // namespace

RobotInWorld::RobotInWorld(const World& world, const Robot& robot, const Stand& stand, std::uint64_t seed, int thin,
                           const DeviceEnds& ends)
    : robot_(robot),
      seed_(seed),
      driven_(world, robot, stand.X_world_base, seed),
      laser_(world, robot, seed, thin),
      pan_(module_config(kPanId, radians(420), radians(360))),
      tilt_(module_config(kTiltId, radians(120), 4.1)),
      lms_([this](MirrorTurn turn) {
        turn.start += lms_power_.on;
        return laser_.look(turn, pan_, tilt_);
      }),
      tracker_([this](std::int64_t sample, Utime) { return sense(sample); }),
      lms_loss_(seed ^ 0x6C6D73),
      tracker_loss_(seed ^ 0x78736E),
      base_loss_(seed ^ 0x657261),
      lms_end_(ends.lms_port),
      can_(serve_can(ends.can)),
      tracker_end_(ends.tracker),
      base_end_(ends.base) {
  put();
}

void RobotInWorld::put() {
  laser_.put_robot(X_world_base());
  // On its way it keeps the errors of the place that it left; each stand has its own.
  orientation_ = std::make_unique<Tracker>(robot_.tracker, X_world_base(), seed_ + 0x9E3779B97F4A7C15U * places_);
}

void RobotInWorld::tell_host_time(double speed) {
  lms_.tell_host_time(speed);
  tracker_.tell_host_time(speed);
}

void RobotInWorld::run(Utime now) {
  begin_faults(now);
  run_pan_tilt(now);
  run_base(now);
  follow_wheels();
  run_lms(now);
  run_tracker(now);
}

void RobotInWorld::run_lms(Utime now) {
  if (!lms_power_.is_on(now)) return;
  lms_end_.open();
  const Utime clock = now - lms_power_.on;
  const TcpEnd::Heard heard = lms_end_.hear();
  if (heard.new_host || !lms_end_.connected()) lms_.hang_up();
  if (const std::string answers = lms_.receive(heard.bytes, clock); !answers.empty()) {
    lms_end_.say(lms_loss_.pass(answers));
  }
  for (const std::string& frame : lms_.tick(clock)) lms_end_.say(lms_loss_.pass(frame));
}

void RobotInWorld::run_pan_tilt(Utime now) {
  auto received = std::exchange(heard_, std::nullopt);
  for (int i = 0; i < kMostFramesATurn && received; ++i, received = can_->receive(0)) {
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
  if (!tracker_power_.is_on(now)) return;
  const Utime clock = now - tracker_power_.on;
  const bool right_rate = tracker_end_.baud() == kTrackerBaud;
  const XbusBytes answers = tracker_.receive(right_rate ? bytes : XbusBytes(), clock);
  const XbusBytes more = tracker_.tick(clock);
  if (!right_rate) return;
  tracker_end_.say(tracker_loss_.pass(answers));
  tracker_end_.say(tracker_loss_.pass(more));
}

void RobotInWorld::run_base(Utime now) {
  const auto bytes = base_end_.hear();
  if (!base_power_.is_on(now)) return;
  const bool right_rate = base_end_.baud() == kBaseBaud;
  const BaseBytes answers = base_.receive(right_rate ? bytes : BaseBytes(), now);
  const BaseBytes more = base_.tick(now);
  if (!right_rate) return;
  base_end_.say(base_loss_.pass(answers));
  base_end_.say(base_loss_.pass(more));
}

void RobotInWorld::follow_wheels() {
  const bool stood = driven_.stands();
  if (driven_.follow(base_.motion())) {
    places_ += !stood && driven_.stands() ? 1 : 0;
    put();
  }
  base_.block(driven_.is_held(base_.wanted_mm_s(), base_.wanted_rad_s()));
}

TrackerSample RobotInWorld::sense(std::int64_t sample) const {
  const TrackerReading reading = orientation_->read(static_cast<int>(sample & 0x7FFFFFFF));
  const Eigen::Matrix3d R_base_tracker = robot_.tracker.R_base_tracker();
  const Eigen::Vector3d turning(0.0, 0.0, base_.motion().turn_rate_rad_s);
  TrackerSample sensed;
  const Eigen::Matrix3d R_biased = rotation_about_z(heading_bias_) * reading.R_world_base.toRotationMatrix() *
                                   exp_so3(Eigen::Vector3d(tilt_bias_, 0.0, 0.0));
  sensed.q_world_sensor = Eigen::Quaterniond(Eigen::Matrix3d(R_biased * R_base_tracker)).normalized();
  sensed.acceleration = R_base_tracker.transpose() * reading.accel;
  sensed.rate_of_turn = R_base_tracker.transpose() * (reading.gyro + turning);
  sensed.magnetic_field = sensed.q_world_sensor.conjugate() * Eigen::Vector3d(0.0, 1.0, 0.0);
  return sensed;
}

}  // namespace scanway::simulator
