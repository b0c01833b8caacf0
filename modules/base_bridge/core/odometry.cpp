#include "modules/base_bridge/core/odometry.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "common/math/repeatable.h"

namespace scanway::erratic {
namespace {

constexpr int kCounts = 4096;  // Of a position counter, until it wraps.
/// A step that is no doubt.
constexpr double kPlausibleStep_m = 0.1;
constexpr double kTopSpeed_m_s = 2.2;
/// After a longer gap at top speed a counter may have wrapped: half its range is 1.6 m.
constexpr Utime kMostGap = 700'000;

/// The shortest way from one count to another, in [-2048, 2047].
int difference(std::uint16_t from, std::uint16_t to) {
  const int forward = (to - from) & (kCounts - 1);
  return forward >= kCounts / 2 ? forward - kCounts : forward;
}

double wrapped(double angle) {
  const double turns = std::floor(angle / (2 * repeatable::kPi) + 0.5);
  const double rest = angle - turns * 2 * repeatable::kPi;
  return rest <= -repeatable::kPi ? repeatable::kPi : rest;
}

/// Whether the robot counts its heading from -2048 or from 0 is not known: whole turns go first.
double heading_of(const MotorReport& report) {
  const int counts = report.heading_counts & (kCounts - 1);
  return repeatable::kPi * (counts > kCounts / 2 ? counts - kCounts : counts) / (kCounts / 2);
}

/// A robot that has just been switched on counts from zero.
bool begins_anew(const MotorReport& report) {
  return report.x_counts == 0 && report.y_counts == 0 && report.heading_counts == 0;
}

}  // namespace

Odometry::Step Odometry::add(const MotorReport& report, Utime now) {
  Step step = Step::added;
  if (!last_ || now - last_->utime > kMostGap || (was_away_ && begins_anew(report))) {
    step = anchor(report);
  } else {
    const int x = difference(last_->x_counts, report.x_counts), y = difference(last_->y_counts, report.y_counts);
    const double furthest = std::max(kPlausibleStep_m, kTopSpeed_m_s * to_seconds(now - last_->utime));
    if (std::max(std::abs(x), std::abs(y)) * metres_per_count_ > furthest) {
      step = Step::dropped;
    } else {
      x_sum_ += x;
      y_sum_ += y;
    }
  }
  was_away_ = false;
  last_ = Last{report.x_counts, report.y_counts, now, begins_anew(report)};
  update(report, now);
  return step;
}

Odometry::Step Odometry::anchor(const MotorReport& report) {
  // One that has not gone anywhere yet says the same, restarted or not.
  if (last_ && last_->at_zero && begins_anew(report)) return Step::added;
  const Step step = !begun_ ? Step::first : begins_anew(report) ? Step::restarted : Step::continued;
  if (step == Step::restarted) turn_ = pose_.heading;
  begun_ = true;
  anchor_x_m_ = pose_.x_m;
  anchor_y_m_ = pose_.y_m;
  x_sum_ = y_sum_ = 0;
  return step;
}

void Odometry::update(const MotorReport& report, Utime now) {
  const double x = static_cast<double>(x_sum_) * metres_per_count_, y = static_cast<double>(y_sum_) * metres_per_count_;
  const double c = repeatable::cos(turn_), s = repeatable::sin(turn_);
  pose_.utime = now;
  pose_.x_m = anchor_x_m_ + (c * x - s * y);
  pose_.y_m = anchor_y_m_ + (s * x + c * y);
  pose_.heading = wrapped(heading_of(report) + turn_);
  pose_.speed_m_s = report.speed_m_s();
  pose_.turn_rate_rad_s = report.turn_rate_rad_s();
}

void Odometry::set_metres_per_count(double metres) {
  anchor_x_m_ = pose_.x_m;
  anchor_y_m_ = pose_.y_m;
  x_sum_ = y_sum_ = 0;
  metres_per_count_ = metres;
}

}  // namespace scanway::erratic
