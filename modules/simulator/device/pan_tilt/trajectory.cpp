#include "modules/simulator/device/pan_tilt/trajectory.h"

#include <algorithm>
#include <cmath>

namespace scanway::simulator {
namespace {

constexpr Utime kRemembered = 10 * kMicrosecondsPerSecond;

double seconds_between(Utime from, Utime to) { return static_cast<double>(to - from) * 1e-6; }
Utime after(Utime time, double seconds) { return time + std::llround(seconds * 1e6); }

}  // namespace

const Trajectory::Stretch& Trajectory::at(Utime time) const {
  const auto later = std::upper_bound(stretches_.begin(), stretches_.end(), time,
                                      [](Utime t, const Stretch& stretch) { return t < stretch.begin; });
  return later == stretches_.begin() ? *later : *(later - 1);
}

double Trajectory::angle(Utime time) const {
  const Stretch& stretch = at(time);
  const double t = std::max(0.0, seconds_between(stretch.begin, time));
  return stretch.angle + stretch.speed * t + 0.5 * stretch.acceleration * t * t;
}

double Trajectory::speed(Utime time) const {
  const Stretch& stretch = at(time);
  return stretch.speed + stretch.acceleration * std::max(0.0, seconds_between(stretch.begin, time));
}

/// A stretch at the present speed, for others to follow; what was still to come is dropped.
void Trajectory::begin(Utime now) {
  const Stretch first{now, angle(now), speed(now), 0.0};
  std::erase_if(stretches_, [&](const Stretch& stretch) { return stretch.begin >= now; });
  const auto recent = std::find_if(stretches_.begin(), stretches_.end(),
                                   [&](const Stretch& stretch) { return stretch.begin > now - kRemembered; });
  if (recent - stretches_.begin() > 1) stretches_.erase(stretches_.begin(), recent - 1);
  stretches_.push_back(first);
}

void Trajectory::accelerate(double to_speed, double acceleration) {
  Stretch& last = stretches_.back();
  const double change = to_speed - last.speed;
  if (change == 0.0) return;
  last.acceleration = std::copysign(acceleration, change);
  const Utime end = after(last.begin, std::fabs(change) / acceleration);
  stretches_.push_back({end, angle(end), to_speed, 0.0});
}

void Trajectory::cruise(double distance) {
  const Stretch last = stretches_.back();
  const Utime end = after(last.begin, std::fabs(distance / last.speed));
  stretches_.push_back({end, angle(end), last.speed, 0.0});
}

void Trajectory::turn_at(double speed, double acceleration, Utime now) {
  begin(now);
  accelerate(speed, acceleration);
}

void Trajectory::stand(double angle, Utime now) {
  begin(now);
  stretches_.back() = {now, angle, 0.0, 0.0};
}

void Trajectory::move_to(double target, double speed, double acceleration, Utime now) {
  begin(now);
  const auto way = [&] { return target - stretches_.back().angle; };
  const double v = stretches_.back().speed;
  const bool fits =
      v == 0.0 || (v * way() > 0.0 && std::fabs(v) <= speed && v * v / (2.0 * acceleration) <= std::fabs(way()));
  if (!fits) accelerate(0.0, acceleration);  // Too fast, or the wrong way: from a stand, then.
  if (const double distance = std::fabs(way()); distance > 0.0) {
    const double u = std::fabs(stretches_.back().speed), sign = std::copysign(1.0, way());
    const double peak = std::min(speed, std::sqrt(acceleration * distance + 0.5 * u * u));
    const double to_brake = peak * peak / (2.0 * acceleration);
    accelerate(sign * peak, acceleration);
    cruise(std::max(0.0, std::fabs(way()) - to_brake));
    accelerate(0.0, acceleration);
  }
  stretches_.back().angle = target;
  stretches_.back().speed = 0.0;
}

}  // namespace scanway::simulator
