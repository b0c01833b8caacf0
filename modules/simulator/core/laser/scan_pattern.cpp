#include "modules/simulator/core/laser/scan_pattern.h"

#include <algorithm>
#include <cmath>

#include "common/math/repeatable.h"
#include "modules/simulator/core/laser/beam_random.h"

namespace scanway::simulator {
namespace {

constexpr double kLineJitter_us = 80.0;  // Recorded scans of an LMS511 come every 39.7 to 40.4 ms.

}  // namespace

ScanPattern::ScanPattern(const Robot& robot, Utime start, std::uint64_t seed, double tilt)
    : X_base_pan0_(robot.mounts.base_mount.pose() * robot.mounts.mount_pan.pose()),
      start_(start),
      seed_(seed),
      tilt_(tilt) {
  Pose X_pan_tilt = Pose::Identity();
  X_pan_tilt.linear() = exp_so3(Eigen::Vector3d(0, tilt, 0));
  X_pan_laser_ = X_pan_tilt * robot.mounts.pan_laser.pose();
  beams_ = robot.laser.beams;
  first_angle_ = -robot.laser.field_of_view / 2;
  angle_step_ = robot.laser.field_of_view / (beams_ - 1);
  line_period_us_ = 1e6 / robot.laser.line_rate_hz;
  beam_period_us_ = line_period_us_ * angle_step_ / (2.0 * repeatable::kPi);
  pan_speed_ = robot.pan.speed_rad_s;
  pan_sweep_ = robot.pan.sweep;
  pan_start_ = -pan_sweep_ / 2;
  lines_ = static_cast<int>(pan_sweep_ / pan_speed_ * robot.laser.line_rate_hz + 1e-6);
  phase_us_ = line_period_us_ * Random(seed ^ 0x5C).uniform();
}

Utime ScanPattern::end() const { return start_ + static_cast<Utime>(std::llround(1e6 * pan_sweep_ / pan_speed_)); }

Utime ScanPattern::line_utime(int line) const {
  const double jitter = kLineJitter_us * (2.0 * beam_random(seed_, line, -1).uniform() - 1.0);
  return start_ + std::max<Utime>(0, std::llround(phase_us_ + line * line_period_us_ + jitter));
}

double ScanPattern::pan_angle(double time_us) const {
  return pan_start_ + std::clamp(pan_speed_ * time_us * 1e-6, 0.0, pan_sweep_);
}

Pose ScanPattern::X_base_laser(double pan) const {
  Pose X_pan0_pan = Pose::Identity();
  X_pan0_pan.linear() = rotation_about_z(pan);
  return X_base_pan0_ * X_pan0_pan * X_pan_laser_;
}

}  // namespace scanway::simulator
