#include "modules/simulator/device/pan_tilt/pan_tilt_module.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "modules/simulator/device/pan_tilt/motion_codes.h"

namespace scanway::simulator {
namespace {

using namespace motion;

constexpr Utime kErrorRepeats = 15'000'000;

}  // namespace

PanTiltModule::PanTiltModule(const ModuleConfig& config)
    : config_(config),
      trajectory_(config.angle),
      low_(config.low),
      high_(config.high),
      speed_(config.max_speed / 4),
      acceleration_(config.acceleration),
      referenced_(config.referenced) {}

void PanTiltModule::power_up(Utime now) {
  booted_ = true;
  activity_ = Activity::standing;
  trajectory_.stand(trajectory_.angle(now), now);
  referenced_ = config_.referenced;
  reached_ = moved_ = false;
  error_ = mask_ = 0;
  state_period_ = 0;
  low_ = config_.low;
  high_ = config_.high;
  impulses_ = true;
  say({kInfo, kBoot, 0});
}

void PanTiltModule::receive(const CanFrame& frame, Utime now) {
  if (frame.id != (static_cast<std::uint16_t>(MotionClass::to_module) | config_.id)) return;
  tick(now);
  if (!booted_) return;
  const auto message = assembler_.add(frame.bytes());
  if (!message) return;
  if (message->empty()) return say({kInfo, kMessageLength});
  obey(*message, now);
}

void PanTiltModule::tick(Utime now) {
  if (!booted_) {
    if (now < boots_until_) return;
    power_up(now);
  }
  watch_limits(now);
  if (jammed_ && activity_ != Activity::standing) fail(kTow, now);
  if (activity_ != Activity::standing && now >= trajectory_.end()) end_of_move(now);
  if (error_ != 0 && now >= error_repeats_) {
    say({kError, error_}, MotionClass::error);
    error_repeats_ = now + kErrorRepeats;
  }
  if (state_period_ > 0 && now >= next_state_) {
    tell_state(now);
    next_state_ = std::max(next_state_ + state_period_, now + 1);  // What it had no time to tell it never tells.
  }
}

std::vector<CanFrame> PanTiltModule::take_frames() { return std::exchange(frames_, {}); }

void PanTiltModule::fail(std::uint8_t code, Utime now) {
  trajectory_.stand(std::max(low_, std::min(high_, trajectory_.angle(now))), now);
  activity_ = Activity::standing;
  reached_ = false;
  moved_ = true;
  error_ = code;
  error_repeats_ = now + kErrorRepeats;
  say({kError, code}, MotionClass::error);
}

void PanTiltModule::reboot(Utime now, Utime dark) {
  trajectory_.stand(trajectory_.angle(now), now);
  booted_ = false;
  boots_until_ = now + dark;
  assembler_ = {};
}

void PanTiltModule::watch_limits(Utime now) {
  if (activity_ != Activity::at_speed || !referenced_) return;
  const double angle = trajectory_.angle(now), speed = trajectory_.speed(now);
  if (angle >= high_ && speed > 0.0) fail(kSoftHigh, now);
  if (angle <= low_ && speed < 0.0) fail(kSoftLow, now);
}

void PanTiltModule::end_of_move(Utime now) {
  const Activity was = std::exchange(activity_, Activity::standing);
  moved_ = true;
  reached_ = was == Activity::to_position || was == Activity::referencing;
  if (was == Activity::referencing) referenced_ = true;
  if (impulses_) tell_standing(reached_ ? kPosReached : kMoveBlocked, now);
}

void PanTiltModule::tell_standing(std::uint8_t impulse, Utime now) {
  MotionMessage message{impulse};
  append_value(message, trajectory_.angle(now));
  say(message);
}

void PanTiltModule::tell_state(Utime now) {
  MotionMessage message{kGetState};
  if ((mask_ & 0x01) != 0) append_value(message, trajectory_.angle(now));
  if ((mask_ & 0x02) != 0) append_value(message, trajectory_.speed(now));
  if ((mask_ & 0x04) != 0) append_little_endian(message, 0, 4);  // No current is simulated.
  unsigned bits = referenced_ ? 0x01 : 0;
  if (activity_ != Activity::standing) {
    bits |= 0x02;
  } else {
    bits |= 0x20U | (!moved_ ? 0U : reached_ ? 0x80U : 0x40U);
  }
  message.push_back(static_cast<std::uint8_t>(bits));
  message.push_back(error_);
  say(message);
}

void PanTiltModule::say(const MotionMessage& message, MotionClass who) {
  for (const CanFrame& frame : frames_of(message, who, config_.id)) frames_.push_back(frame);
}

double PanTiltModule::radians_per_unit() const {
  switch (config_.units) {
    case MotionUnits::radian:
      return 1.0;
    case MotionUnits::microdegree:
      return radians(1e-6L);
    case MotionUnits::millidegree:
      return radians(1e-3L);
    default:
      return radians(1.0L);
  }
}

void PanTiltModule::append_value(MotionMessage& message, double radians) const {
  const double value = radians / radians_per_unit();
  append_little_endian(message,
                       whole_numbers() ? static_cast<std::uint32_t>(std::llround(value))
                                       : std::bit_cast<std::uint32_t>(static_cast<float>(value)),
                       4);
}

std::vector<double> PanTiltModule::values_of(const MotionMessage& message) const {
  std::vector<double> values;
  for (std::size_t at = 1; at + 4 <= message.size(); at += 4) {
    const std::uint32_t word = little_endian(std::span(message).subspan(at, 4));
    const double value = whole_numbers() ? static_cast<std::int32_t>(word) : std::bit_cast<float>(word);
    values.push_back(value * radians_per_unit());
  }
  return values;
}

}  // namespace scanway::simulator
