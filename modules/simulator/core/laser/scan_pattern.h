#pragma once

#include <cstdint>

#include "common/geometry/pose.h"
#include "common/robot/robot.h"
#include "common/time/utime.h"

namespace scanway::simulator {

/// When and where to each beam of a sweep goes. The mirror turns all the time and knows nothing of the pan: the first
/// line of a sweep begins some milliseconds after the pan does, and its period wanders a little.
///
/// Frames: X_base_laser = X_base_mount X_mount_pan Rz(pan) Ry(tilt) X_pan_laser; beam i of a line leaves along
/// (cos a, sin a, 0) of `laser` with a = first_angle + i angle_step, at line_utime + i beam_period.
class ScanPattern {
 public:
  /// `start`: when the pan begins to turn. The seed decides how the mirror stands then.
  ScanPattern(const Robot& robot, Utime start, std::uint64_t seed, double tilt = 0.0);

  int lines() const { return lines_; }
  int beams() const { return beams_; }
  double first_angle() const { return first_angle_; }
  double angle_step() const { return angle_step_; }
  double beam_period_us() const { return beam_period_us_; }
  double angle(int beam) const { return first_angle_ + beam * angle_step_; }

  Utime start() const { return start_; }
  /// When the pan stands again.
  Utime end() const;
  /// Of the line's first beam.
  Utime line_utime(int line) const;
  /// Microseconds since start().
  double beam_time_us(int line, int beam) const {
    return static_cast<double>(line_utime(line) - start_) + beam * beam_period_us_;
  }

  double pan_start() const { return pan_start_; }
  double pan_end() const { return pan_start_ + pan_sweep_; }
  double pan_speed() const { return pan_speed_; }
  double tilt() const { return tilt_; }
  /// `time_us` since start(); before and after the sweep the pan stands.
  double pan_angle(double time_us) const;

  Pose X_base_laser(double pan) const;

 private:
  Pose X_base_pan0_;
  Pose X_pan_laser_;  // With the tilt.
  Utime start_;
  std::uint64_t seed_;
  int lines_, beams_;
  double first_angle_, angle_step_, line_period_us_, beam_period_us_, phase_us_;
  double pan_start_, pan_speed_, pan_sweep_, tilt_;
};

}  // namespace scanway::simulator
