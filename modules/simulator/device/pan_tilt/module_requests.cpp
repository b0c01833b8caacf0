// What a module makes of the messages to it.

#include <algorithm>
#include <bit>
#include <cmath>
#include <string_view>

#include "modules/simulator/device/pan_tilt/motion_codes.h"
#include "modules/simulator/device/pan_tilt/pan_tilt_module.h"

namespace scanway::simulator {
namespace {

using namespace motion;

constexpr Utime kBootTime = 2'500'000;

}  // namespace

void PanTiltModule::obey(const MotionMessage& message, Utime now) {
  const std::uint8_t command = message[0];
  switch (command) {
    case kGetConfig:
      return get_config(message);
    case kSetConfig:
      return set_config(message);
    case kAck:
      return acknowledge();
    case kFastStop:
      return fail(kFastStopped, now);
    case kStop:
      say_ok(command);
      trajectory_.turn_at(0.0, acceleration_, now);
      activity_ = Activity::braking;
      return;
    case kReference:
    case kMovePos:
    case kMovePosRel:
    case kMoveVel:
      return obey_move(command, values_of(message), now);
    case kGetState:
      return start_state(message, now);
    case kDetailedError:
      if (error_ == 0) return refuse(command, kFailed);
      return say({command, kError, error_, 0, 0, 0, 0});
    case kReboot:
      say_ok(command);
      return reboot(now, kBootTime);
    case kChangeUser:
      return say({command, 'O', 'K', 0});
    case kToggleImpulse:
      impulses_ = !impulses_;
      return say(impulses_ ? MotionMessage{command, 'O', 'N'} : MotionMessage{command, 'O', 'F', 'F'});
    default:
      break;
  }
  if (command < kTargetVel || command > kTargetTime) return refuse(command, kUnknownCommand);
  const auto values = values_of(message);
  if (values.size() != 1 || !std::isfinite(values[0]) || !(values[0] > 0.0)) return refuse(command, kWrongParameter);
  set_target(command, values[0]);
  say_ok(command);
}

void PanTiltModule::set_target(std::uint8_t command, double value) {
  // Jerk, current and time are taken and have no effect.
  constexpr double kLeast = 1e-4;
  if (command == kTargetVel) speed_ = std::clamp(value, kLeast, config_.max_speed);
  if (command == kTargetAcc) acceleration_ = std::max(value, kLeast);
}

/// Of a position move: position, then perhaps speed, acceleration, current, jerk; of the others speed and current.
void PanTiltModule::obey_move(std::uint8_t command, std::vector<double> values, Utime now) {
  if (error_ != 0) return refuse(command, kFailed);
  if (command == kReference) {
    say_ok(command);
    trajectory_.move_to(0.0, config_.reference_speed, acceleration_, now);
    activity_ = Activity::referencing;
    return;
  }
  const auto is_limit = [](double value) { return std::isfinite(value) && value > 0.0; };
  if (values.empty() || !std::isfinite(values[0]) || !std::all_of(values.begin() + 1, values.end(), is_limit)) {
    return refuse(command, kWrongParameter);
  }
  if (command == kMoveVel) {
    if (std::fabs(values[0]) > config_.max_speed * (1 + 1e-6)) return refuse(command, kAboveLimit);
    say_ok(command);
    trajectory_.turn_at(values[0], acceleration_, now);
    activity_ = Activity::at_speed;
    return;
  }
  if (!referenced_ && command == kMovePos) return refuse(command, kNotReferenced);
  const double target = values[0] + (command == kMovePosRel ? trajectory_.angle(now) : 0.0);
  if (beyond(target)) return refuse(command, kAboveLimit);
  if (values.size() > 1) set_target(kTargetVel, values[1]);
  if (values.size() > 2) set_target(kTargetAcc, values[2]);
  trajectory_.move_to(target, speed_, acceleration_, now);
  activity_ = Activity::to_position;
  const double seconds = static_cast<double>(trajectory_.end() - now) * 1e-6;
  MotionMessage answer{command};
  append_little_endian(answer,
                       whole_numbers() ? static_cast<std::uint32_t>(std::lround(seconds * 1e3))
                                       : std::bit_cast<std::uint32_t>(static_cast<float>(seconds)),
                       4);
  say(answer);
}

void PanTiltModule::start_state(const MotionMessage& message, Utime now) {
  if (message.size() != 1 && message.size() != 6) return say({kInfo, kMessageLength});
  if (message.size() == 6) {
    const std::uint32_t period = little_endian(std::span(message).subspan(1, 4));
    const double seconds = whole_numbers() ? period * 1e-3 : static_cast<double>(std::bit_cast<float>(period));
    if (!(seconds >= 0.0 && seconds < 1e6)) return refuse(kGetState, kWrongParameter);
    state_period_ = std::llround(seconds * 1e6);
    mask_ = message[5];
    next_state_ = now + state_period_;
  }
  tell_state(now);
}

void PanTiltModule::get_config(const MotionMessage& message) {
  MotionMessage answer;
  answer.reserve(64);
  answer.push_back(kGetConfig);
  if (message.size() == 1) {
    // Type, order number, versions of firmware, protocol and hardware, date of the firmware, and five unknown bytes.
    constexpr std::string_view kType("PW-70\0\0\0", 8), kDate("Mar 12 2012 10:00:00\0", 21);
    answer.insert(answer.end(), kType.begin(), kType.end());
    append_little_endian(answer, 310'950, 4);
    for (const std::uint32_t version : {160U, 3U, 100U}) append_little_endian(answer, version, 2);
    answer.insert(answer.end(), kDate.begin(), kDate.end());
    answer.insert(answer.end(), 5, 0);
    return say(answer);
  }
  answer.push_back(message[1]);
  switch (message[1]) {
    case 0x01:
      answer.push_back(config_.id);
      break;
    case 0x02:
      answer.push_back(0);
      break;
    case 0x04:
      append_little_endian(answer, 500, 2);
      break;
    case 0x05:
      answer.push_back(2);
      break;
    case 0x06:
      answer.push_back(static_cast<std::uint8_t>(config_.units));
      break;
    case 0x07:
      append_value(answer, high_);
      break;
    case 0x08:
      append_value(answer, low_);
      break;
    case 0x09:
      append_value(answer, config_.max_speed);
      break;
    case 0x0A:
      append_value(answer, config_.acceleration);
      break;
    case 0x15:
    case 0x16:
      append_little_endian(answer, 310'950, 4);
      break;
    default:
      return refuse(kGetConfig, kWrongParameter);
  }
  say(answer);
}

void PanTiltModule::set_config(const MotionMessage& message) {
  if (message.size() < 3) return refuse(kSetConfig, kWrongParameter);
  const std::uint8_t setting = message[1];
  if ((setting == 0x07 || setting == 0x08) && message.size() == 6) {
    const double limit = values_of({message.begin() + 1, message.end()}).at(0);
    if (!(limit >= config_.low && limit <= config_.high)) return refuse(kSetConfig, kWrongParameter);
    (setting == 0x07 ? high_ : low_) = limit;
  }
  say({kSetConfig, 'O', 'K', setting});
}

void PanTiltModule::acknowledge() {
  say_ok(kAck);
  if (error_ == 0) return;
  error_ = 0;
  if (impulses_) say({kInfo, kNoError, 0});
}

}  // namespace scanway::simulator
