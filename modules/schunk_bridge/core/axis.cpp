#include "modules/schunk_bridge/core/axis.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "modules/schunk_bridge/core/request.h"

namespace scanway::schunk {
namespace {

constexpr Utime kAskAgainAfter = 500'000;  // While the module is absent.
constexpr Utime kAskAgainIfUnusableAfter = 5'000'000;
constexpr Utime kAbsenceToldAfter = 2'000'000;
constexpr Utime kLeastSilence = 500'000;  // That makes a module count as lost.

/// Before a turning axis has taken a stop: the rhythm of its states, and the way of the stop.
constexpr double kTimeToStop_s = 0.1;

std::string degrees_text(double angle) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f", angle / radians(1.0L));
  return text;
}

Utime silence_limit(const AxisConfig& config) {
  return std::max(kLeastSilence, static_cast<Utime>(10e6 * config.state_period_s));
}

}  // namespace

Axis::Axis(AxisConfig config)
    : config_(std::move(config)), low_(config_.low), high_(config_.high), max_speed_(config_.max_speed) {}

void Axis::receive(const CanFrame& frame, Utime now) {
  const bool from_module = frame.id == can_id(Direction::from_module, config_.module) ||
                           frame.id == can_id(Direction::error, config_.module);
  if (!from_module) return;
  const MessageAssembler::Result result = assembler_.add(frame, 0, now);
  counters_.bad_frames += result.bad.size();
  if (result.message) take(*result.message, now);
}

void Axis::frames_lost() { counters_.bad_frames += assembler_.give_up("frames were lost").size(); }

void Axis::clock_was_set(Utime now) {
  since_ = error_utime_ = now;
  asked_last_.reset();
  if (state_) state_->utime = now;
}

void Axis::tick(Utime now) {
  if (!since_) since_ = now;
  if (const auto asked = conversation_.given_up(now)) take_silence(*asked, now);
  // A stop drops what the set-up still had to ask.
  if (phase_ == Phase::setting_up && conversation_.idle()) phase_ = Phase::absent;
  if (phase_ == Phase::absent || phase_ == Phase::unusable) {
    ask_for_units(now);
    if (phase_ == Phase::absent && !told_absence_ && now - *since_ > kAbsenceToldAfter) {
      told_absence_ = true;
      tell(Event::Kind::lost, now,
           "does not answer: check its power, its module id, and the bit rate, wiring and termination of the CAN bus");
    }
  } else if (phase_ == Phase::ready && state_ && now - state_->utime > silence_limit(config_)) {
    lose("has fallen silent: check its power and the CAN cable", now);
  }
}

void Axis::ask_for_units(Utime now) {
  const Utime rhythm = phase_ == Phase::absent ? kAskAgainAfter : kAskAgainIfUnusableAfter;
  if (!conversation_.idle() || (asked_last_ && now - *asked_last_ < rhythm)) return;
  asked_last_ = now;
  conversation_.ask(request::get_config(config_.module, Setting::unit_system));
}

std::string Axis::why_no_move() const {
  if (phase_ == Phase::unusable) return config_.name + " cannot be used as it is set up";
  if (phase_ != Phase::ready) return config_.name + " does not answer";
  if (error_ != 0) {
    const std::string_view advice = advice_on_code(error_);
    return config_.name + " has error " + describe_code(error_) + (advice.empty() ? "" : ": ") + std::string(advice);
  }
  if (motion_.under_way()) return config_.name + " is moving: stop it first";
  // After a stop it turns on for a moment; at the start, whoever moved it may be gone.
  if ((state_->bits & state_bit::kMoving) != 0) return config_.name + " still turns: stop it, or wait until it stands";
  return {};
}

std::string Axis::why_not_at(double speed) const {
  if (speed > 0 && speed <= max_speed_) return {};
  return config_.name + " cannot go at " + degrees_text(speed) + " deg/s: its limit is " + degrees_text(max_speed_) +
         " deg/s";
}

std::string Axis::reference(Utime) {
  if (std::string why = why_no_move(); !why.empty()) return why;
  motion_.begin(Motion::Kind::reference, 0, 0);
  conversation_.ask(request::plain(config_.module, Command::cmd_reference));
  return {};
}

std::string Axis::move_to(double position, double speed, Utime) {
  if (std::string why = why_no_move(); !why.empty()) return why;
  if (!referenced()) return config_.name + " is not referenced: send it to its reference first";
  if (!(position >= low_ && position <= high_)) {
    return config_.name + " cannot go to " + degrees_text(position) + " deg: its limits are " + degrees_text(low_) +
           " and " + degrees_text(high_) + " deg";
  }
  if (std::string why = why_not_at(speed); !why.empty()) return why;
  motion_.begin(Motion::Kind::position, position, speed);
  // The target speed first, on its own: together the two would need a fragmented message.
  conversation_.ask(request::with_values(config_.module, Command::set_target_vel, {from_radians(speed)}, units_));
  conversation_.ask(request::with_values(config_.module, Command::move_pos, {from_radians(position)}, units_));
  return {};
}

std::string Axis::move_at(double speed, Utime) {
  if (std::string why = why_no_move(); !why.empty()) return why;
  if (std::string why = why_not_at(std::fabs(speed)); !why.empty()) return why;
  if (referenced() && (speed > 0 ? state_->position >= high_ : state_->position <= low_)) {
    return config_.name + " is at its limit of " + degrees_text(speed > 0 ? high_ : low_) + " deg: turn it back";
  }
  turning_at_ = speed;
  motion_.begin(Motion::Kind::velocity, state_->position, std::fabs(speed));
  conversation_.ask(request::with_values(config_.module, Command::move_vel, {from_radians(speed)}, units_));
  return {};
}

void Axis::stop() {
  motion_.fail();
  conversation_.urge(request::plain(config_.module, Command::cmd_stop));
}

void Axis::fast_stop() {
  motion_.fail();
  conversation_.urge(request::plain(config_.module, Command::cmd_fast_stop));
}

void Axis::watch_limits(Utime now) {
  if (motion_.kind() != Motion::Kind::velocity || !motion_.under_way() || !referenced()) return;
  const double soon = state_->position + kTimeToStop_s * turning_at_;
  if (turning_at_ > 0 ? soon < high_ : soon > low_) return;
  stop();
  tell(Event::Kind::blocked, now, "has come to its limit: it has been stopped");
}

std::string Axis::acknowledge() {
  if (phase_ != Phase::ready) return config_.name + " does not answer";
  conversation_.ask(request::plain(config_.module, Command::cmd_ack));
  return {};
}

std::string Axis::description() const {
  std::string text = info_ ? info_->type : "module";
  text += ' ';
  text += std::to_string(config_.module);
  if (info_) {
    char firmware[32];
    std::snprintf(firmware, sizeof firmware, ", firmware %.2f", info_->firmware);
    text += firmware;
  }
  text += ", counts in " + std::string(name_of(units_));
  return text + ", limits " + degrees_text(low_) + " to " + degrees_text(high_) + " deg, at most " +
         degrees_text(max_speed_) + " deg/s";
}

void Axis::lose(const std::string& why, Utime now) {
  ++counters_.times_lost;
  conversation_.clear();
  assembler_.give_up(why);
  motion_.fail();
  phase_ = Phase::absent;
  since_ = now;
  asked_last_.reset();
  told_absence_ = true;
  tell(Event::Kind::lost, now, why);
}

void Axis::tell(Event::Kind kind, Utime now, std::string text, std::uint8_t code) {
  Event event;
  event.kind = kind;
  event.utime = now;
  event.axis = config_.name;
  event.code = code;
  if (state_) event.position = state_->position;
  event.text = config_.name + " (module " + std::to_string(config_.module) + ") " + text;
  events_.push_back(std::move(event));
}

std::vector<AxisState> Axis::take_states() { return std::exchange(states_, {}); }

std::vector<Event> Axis::take_events() { return std::exchange(events_, {}); }

}  // namespace scanway::schunk
