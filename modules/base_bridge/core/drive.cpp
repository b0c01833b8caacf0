#include "modules/base_bridge/core/drive.h"

#include <algorithm>
#include <cmath>

namespace scanway::erratic {
namespace {

/// The robot takes at most one pair of velocities in this time.
constexpr Utime kBetweenVelocities = 50'000;

int rounded(double value) { return static_cast<int>(std::floor(value + 0.5)); }

}  // namespace

void Drive::set(double speed_m_s, double turn_rate_rad_s, Utime now) {
  const double excess = std::max(
      {1.0, std::fabs(speed_m_s) / config_.max_speed_m_s, std::fabs(turn_rate_rad_s) / config_.max_turn_rate_rad_s});
  const int speed = rounded(speed_m_s / excess * 1000.0), turn_rate = rounded(turn_rate_rad_s / excess / radians(1.0L));
  changed_ = changed_ || !valid_ || speed != speed_mm_s_ || turn_rate != turn_rate_deg_s_;
  speed_mm_s_ = speed;
  turn_rate_deg_s_ = turn_rate;
  valid_ = true;
  commanded_ = now;
}

void Drive::stop(Utime now) {
  commanded_ = now;
  halt(now);
}

void Drive::halt(Utime now) {
  valid_ = changed_ = false;
  // The plain stop first: it is what counts, and the pacing of packets delays the others.
  packets_ = {make_command(Command::stop), make_command(Command::trans_vel, 0), make_command(Command::rot_vel, 0)};
  velocity_sent_ = now;
}

void Drive::shut_down(Utime now) {
  halt(now);
  packets_.push_back(make_command(Command::enable_motors, 0));
  motors_on_ = false;
}

void Drive::reset() {
  packets_.clear();
  valid_ = changed_ = motors_on_ = false;
}

void Drive::clock_was_set(Utime now) {
  halt(now);
  commanded_ = now - config_.motors_off_after;
  pulse_sent_ = now;
}

bool Drive::tick(Utime now) {
  const bool ran_out = valid_ && now - commanded_ >= config_.lifetime;
  if (ran_out) halt(now);
  if (!valid_ && motors_on_ && now - commanded_ >= config_.motors_off_after) {
    packets_.push_back(make_command(Command::enable_motors, 0));
    motors_on_ = false;
  }
  if (valid_ && packets_.empty()) send_velocity(now);
  if (!valid_ && packets_.empty() && now - pulse_sent_ >= config_.pulse_period) {
    packets_.push_back(make_command(Command::pulse));
    pulse_sent_ = now;
  }
  return ran_out;
}

void Drive::send_velocity(Utime now) {
  const Utime since = velocity_sent_ ? now - *velocity_sent_ : config_.repeat_period;
  if (since < kBetweenVelocities || (!changed_ && since < config_.repeat_period)) return;
  if (!motors_on_) packets_.push_back(make_command(Command::enable_motors, 1));
  packets_.push_back(make_command(Command::trans_vel, speed_mm_s_));
  packets_.push_back(make_command(Command::rot_vel, turn_rate_deg_s_));
  motors_on_ = true;
  changed_ = false;
  velocity_sent_ = now;
}

Packet Drive::take() {
  Packet packet = std::move(packets_.front());
  packets_.pop_front();
  return packet;
}

}  // namespace scanway::erratic
