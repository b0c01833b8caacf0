// What an axis makes of the messages of its module.

#include <algorithm>
#include <cmath>

#include "modules/schunk_bridge/core/axis.h"
#include "modules/schunk_bridge/core/request.h"

namespace scanway::schunk {
namespace {

constexpr std::size_t kMostStates = 512;
std::uint8_t mask_of(const AxisConfig& config) {
  return config.ask_velocity ? state_mask::kPosition | state_mask::kVelocity : state_mask::kPosition;
}

std::string reason_with(const std::string& what, std::uint8_t code) {
  const std::string_view advice = advice_on_code(code);
  return what + " " + describe_code(code) + (advice.empty() ? "" : ": " + std::string(advice));
}

bool is_move(Command command) {
  return command == Command::move_pos || command == Command::move_vel || command == Command::cmd_reference;
}

}  // namespace

void Axis::take(const Message& message, Utime now) {
  const Reply reply = parse_reply(message, mask_of(config_), units_);
  if (std::holds_alternative<reply::Malformed>(reply)) {
    ++counters_.bad_frames;
    return;
  }
  const auto asked = conversation_.answered_by(message, reply);
  if (const auto* alert = std::get_if<reply::Alert>(&reply)) {
    if (asked && message.command == Command::cmd_info) return take_failure(*asked, alert->code, now);
    return take_alert(message, *alert, now);
  }
  if (const auto* state = std::get_if<reply::State>(&reply)) {
    if (phase_ == Phase::setting_up || phase_ == Phase::ready) take_state(*state, message.utime, now);
  } else if (const auto* standing = std::get_if<reply::Standing>(&reply)) {
    if (phase_ == Phase::ready) take_standing(to_radians(standing->position), message.utime, now);
  } else if (asked) {
    take_answer(*asked, reply, now);
  }
}

void Axis::take_alert(const Message& message, const reply::Alert& alert, Utime now) {
  constexpr std::uint8_t kBoot = 0x01, kNoError = 0x08;
  if (message.command == Command::cmd_error) {
    set_error(alert.code, now);
  } else if (message.command == Command::cmd_warning) {
    if (alert.code != warning_) tell(Event::Kind::warning, now, reason_with("warns:", alert.code), alert.code);
    warning_ = alert.code;
  } else if (alert.code == kBoot) {
    motion_.fail();
    conversation_.clear();
    tell(Event::Kind::booted, now, "has restarted");
    begin_setup(now);
  } else if (alert.code == kNoError) {
    clear_error(now);
  } else {
    tell(Event::Kind::info, now, "says " + describe_code(alert.code), alert.code);
  }
}

void Axis::begin_setup(Utime now) {
  phase_ = Phase::absent;
  since_ = now;
  state_.reset();
  asked_last_.reset();
}

void Axis::take_state(const reply::State& state, Utime utime, Utime now) {
  AxisState next;
  next.utime = utime;
  next.position = to_radians(*state.position);
  if (state.velocity) next.velocity = to_radians(*state.velocity);
  next.bits = state.bits;
  next.error = state.error;
  state_ = next;
  if (states_.size() >= kMostStates) states_.erase(states_.begin());
  states_.push_back(next);
  if (phase_ == Phase::setting_up) {
    phase_ = Phase::ready;
    told_absence_ = told_refusal_ = false;
    tell(Event::Kind::found, now, "is ready: " + description());
  }
  // The error bit may be clear although there is an error, so its code decides; warnings share the byte.
  const bool only_warns = (state.bits & state_bit::kWarning) != 0 && (state.bits & state_bit::kError) == 0;
  if (state.error != 0 && !only_warns) {
    set_error(state.error, now);
  } else if (utime > error_utime_) {
    clear_error(now);
  }
  if ((state.bits & state_bit::kWarning) == 0) warning_ = 0;
  report_motion(motion_.observe(next.position, state.bits, now), now);
  watch_limits(now);
}

void Axis::take_standing(double position, Utime utime, Utime now) {
  // As good as a state, and newer than the last one.
  state_->utime = utime;
  state_->position = position;
  if (state_->velocity) state_->velocity = 0.0;
  state_->bits &= static_cast<std::uint8_t>(~state_bit::kMoving);
  report_motion(motion_.announce_stand(position), now);
}

void Axis::take_answer(const Asked& asked, const Reply& reply, Utime now) {
  if (const auto* failure = std::get_if<reply::Failure>(&reply)) return take_failure(asked, failure->code, now);
  const Command command = asked.message.command;
  if (const auto* setting = std::get_if<reply::SettingValue>(&reply)) {
    if (setting->setting == Setting::unit_system) return take_units(*setting, now);
    take_setting(*setting);
  } else if (const auto* info = std::get_if<reply::ModuleInfo>(&reply)) {
    info_ = *info;
  } else if (command == Command::get_state) {
    ask_for_state();  // A bare OK instead of a state, as happens now and then.
  } else if (command == Command::cmd_stop) {
    tell(Event::Kind::stopped, now, "has been stopped");
  } else if (is_move(command) && motion_.under_way()) {
    const auto* duration = std::get_if<reply::Duration>(&reply);
    motion_.accept(duration ? std::optional(duration->seconds) : std::nullopt, state_ ? state_->position : 0.0, now);
    tell(Event::Kind::started, now, "moves: " + std::string(name_of(command)));
  }
}

void Axis::take_units(const reply::SettingValue& value, Utime now) {
  units_ = static_cast<UnitSystem>(value.bytes[0]);
  const auto scale = radians_per_unit(units_);
  if (!scale) {
    if (phase_ == Phase::unusable) return;
    phase_ = Phase::unusable;
    const std::string units = is_known(units_) ? std::string(name_of(units_)) : describe_code(value.bytes[0]);
    tell(Event::Kind::refused, now,
         "counts in '" + units + "', which is no angle: is it the right module? Set its unit system to rad or deg");
    return;
  }
  scale_ = *scale;
  low_ = config_.low;
  high_ = config_.high;
  max_speed_ = config_.max_speed;
  info_.reset();
  phase_ = Phase::setting_up;
  for (const Setting setting : {Setting::soft_low, Setting::soft_high, Setting::max_velocity}) {
    conversation_.ask(request::get_config(config_.module, setting), false);
  }
  conversation_.ask(request::plain(config_.module, Command::get_config), false);
  if (config_.acceleration > 0) {
    const double acceleration = from_radians(config_.acceleration);
    conversation_.ask(request::with_values(config_.module, Command::set_target_acc, {acceleration}, units_), false);
  }
  ask_for_state();
}

void Axis::ask_for_state() {
  conversation_.ask(request::get_state(config_.module, config_.state_period_s, mask_of(config_), units_));
}

void Axis::take_setting(const reply::SettingValue& value) {
  const double angle = to_radians(value.value);
  switch (value.setting) {
    case Setting::soft_low:
      low_ = std::max(low_, angle);
      break;
    case Setting::soft_high:
      high_ = std::min(high_, angle);
      break;
    case Setting::max_velocity:
      if (angle > 0) max_speed_ = std::min(max_speed_, angle);
      break;
    default:
      break;
  }
}

void Axis::take_failure(const Asked& asked, std::uint8_t code, Utime now) {
  const std::string what = "refused " + std::string(name_of(asked.message.command)) + " with";
  if (asked.needed && (phase_ == Phase::ready || !told_refusal_)) {
    tell(Event::Kind::refused, now, reason_with(what, code), code);
    told_refusal_ = phase_ != Phase::ready;
  }
  if (is_move(asked.message.command) || asked.message.command == Command::set_target_vel) {
    motion_.fail();
    conversation_.clear();
  } else if (asked.needed && phase_ != Phase::ready) {
    phase_ = Phase::absent;  // Setting up begins again, in its rhythm.
    conversation_.clear();
  }
}

void Axis::take_silence(const Asked& asked, Utime now) {
  if (!asked.needed || phase_ == Phase::absent || phase_ == Phase::unusable) return;
  lose("did not answer " + std::string(name_of(asked.message.command)) + ": check its power and the CAN cable", now);
}

void Axis::set_error(std::uint8_t code, Utime now) {
  error_utime_ = now;
  if (code == error_) return;
  error_ = code;
  if (phase_ == Phase::ready) conversation_.clear_unless_urgent();
  motion_.fail();
  tell(Event::Kind::error, now, reason_with("has error", code), code);
}

void Axis::clear_error(Utime now) {
  if (error_ == 0) return;
  error_ = 0;
  tell(Event::Kind::cleared, now, "has no error any more");
}

void Axis::report_motion(Motion::Change change, Utime now) {
  const bool reference = motion_.kind() == Motion::Kind::reference;
  switch (change) {
    case Motion::Change::nothing:
      return;
    case Motion::Change::reached:
      return tell(reference ? Event::Kind::referenced : Event::Kind::reached, now,
                  reference ? "is referenced" : "has reached its target");
    case Motion::Change::blocked:
      return tell(Event::Kind::blocked, now,
                  reference ? "stands without having found its reference" : "stands before its target: is it blocked?");
    case Motion::Change::stuck:
      stop();
      return tell(Event::Kind::blocked, now, "says that it moves, and does not: is it blocked?");
    case Motion::Change::overdue:
      stop();
      return tell(Event::Kind::blocked, now, "takes much longer than its way should: it has been stopped");
  }
}

}  // namespace scanway::schunk
