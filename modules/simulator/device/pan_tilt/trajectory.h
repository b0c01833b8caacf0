#pragma once

#include <vector>

#include "common/time/utime.h"

namespace scanway::simulator {

/// The angle of an axis over time: stretches of constant acceleration, radians. A new move begins where and as fast as
/// the one that it replaces is at that moment.
class Trajectory {
 public:
  explicit Trajectory(double angle) : stretches_{{0, angle, 0.0, 0.0}} {}

  /// Of any time up to now, and some seconds back; and of later ones, if nothing is commanded meanwhile.
  double angle(Utime time) const;
  double speed(Utime time) const;
  /// When it stands, at the latest; never for a turn without end.
  Utime end() const { return stretches_.back().speed == 0.0 ? stretches_.back().begin : kNever; }

  /// Each with the acceleration in rad/s^2, up to the speed in rad/s.
  void move_to(double target, double speed, double acceleration, Utime now);
  void turn_at(double speed, double acceleration, Utime now);
  /// Stands at once, at `angle`.
  void stand(double angle, Utime now);

  static constexpr Utime kNever = INT64_MAX;

 private:
  struct Stretch {
    Utime begin;
    double angle, speed, acceleration;
  };
  const Stretch& at(Utime time) const;
  void begin(Utime now);
  void accelerate(double to_speed, double acceleration);
  void cruise(double distance);

  std::vector<Stretch> stretches_;  // By time; the last one without end.
};

}  // namespace scanway::simulator
