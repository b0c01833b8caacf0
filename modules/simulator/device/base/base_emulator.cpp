#include "modules/simulator/device/base/base_emulator.h"

#include <algorithm>
#include <cmath>

#include "common/math/angle.h"
#include "common/math/repeatable.h"

namespace scanway::simulator {
namespace {

enum : std::uint8_t {
  kOpen = 1,
  kClose = 2,
  kEnableMotors = 4,
  kMaxAcceleration = 5,
  kSpeed = 11,
  kConfiguration = 18,
  kTurnRate = 21,
  kMaxTurnAcceleration = 23,
  kStop = 29,
  kWheelSpeeds = 32,
};

constexpr double kWheelCount_mm_s = 1.20482, kHeadingCounts = 4096.0;
constexpr double kWheelDistance_mm = 2.0 / 0.011 / 0.596;  // By which the host makes a turn rate of two wheel speeds.
constexpr double kWheelUnit_mm_s = 20.0;
constexpr Utime kStep = 5'000, kMostBehind = kMicrosecondsPerSecond;

double towards(double value, double wanted, double most) { return value + std::clamp(wanted - value, -most, most); }

std::int16_t count(double value) {
  return static_cast<std::int16_t>(static_cast<std::uint16_t>(std::llround(value) & 0xFFFF));
}

std::uint32_t position_count(double mm, const std::string& subtype) {
  const double scale = subtype == "Rev H" ? 0.930 : 0.780;
  return static_cast<std::uint32_t>(std::llround(mm / scale)) & 0xFFFFFF;
}

}  // namespace

BaseBytes BaseEmulator::receive(std::span<const std::uint8_t> bytes, Utime now) {
  BaseBytes answers;
  advance(now);
  requests_.push(bytes);
  while (const auto request = requests_.next()) {
    commanded_ = now;
    obey(*request, answers, now);
  }
  return answers;
}

void BaseEmulator::obey(const BaseRequest& request, BaseBytes& answers, Utime now) {
  const auto limited = [](double value, double most) { return std::clamp(value, -most, most); };
  const auto drive = [&](double mm_s, double rad_s) {
    wanted_mm_s_ = limited(mm_s, config_.max_speed_mm_s);
    wanted_rad_s_ = limited(rad_s, config_.max_turn_rad_s);
  };
  switch (request.command) {
    case kConfiguration:
      answers = configuration_packet(config_.name, "Erratic", config_.subtype);
      return;
    case kOpen:
      open_ = true;
      next_report_ = now;
      return;
    case kClose:
      open_ = false;
      return stand();
    case kEnableMotors:
      motors_on_ = request.number == 1;
      return motors_on_ ? void() : stand();
    case kSpeed:
      return drive(request.number, wanted_rad_s_);
    case kTurnRate:
      return drive(wanted_mm_s_, request.number * radians(1));
    case kWheelSpeeds: {
      if (request.argument.size() < 2) return;
      const double right = static_cast<std::int8_t>(request.argument[0]) * kWheelUnit_mm_s;
      const double left = static_cast<std::int8_t>(request.argument[1]) * kWheelUnit_mm_s;
      return drive((left + right) / 2, (right - left) / kWheelDistance_mm);
    }
    case kMaxAcceleration:
      if (request.number > 0) config_.acceleration_mm_s2 = request.number;
      return;
    case kMaxTurnAcceleration:
      if (request.number > 0) config_.turn_acceleration_rad_s2 = request.number * radians(1);
      return;
    case kStop:
      return stand();
    default:
      return;  // Gains, sonar and the like change nothing here.
  }
}

void BaseEmulator::stand() {
  wanted_mm_s_ = wanted_rad_s_ = 0.0;
  motion_.speed_mm_s = motion_.turn_rate_rad_s = 0.0;
}

void BaseEmulator::reboot() {
  stand();
  motion_ = {};
  requests_ = {};
  open_ = motors_on_ = false;
}

BaseBytes BaseEmulator::tick(Utime now) {
  advance(now);
  if (!open_ || now < next_report_) return {};
  next_report_ = std::max(next_report_ + config_.report_period, now - config_.report_period);
  return report();
}

void BaseEmulator::advance(Utime now) {
  if (now - advanced_ > kMostBehind) advanced_ = now - kMostBehind;
  for (; advanced_ + kStep <= now; advanced_ += kStep) {
    if (config_.watchdog > 0 && advanced_ - commanded_ > config_.watchdog) wanted_mm_s_ = wanted_rad_s_ = 0.0;
    step(static_cast<double>(kStep) * 1e-6);
  }
}

void BaseEmulator::step(double seconds) {
  if (!motors_on_ || blocked_) {
    motion_.speed_mm_s = motion_.turn_rate_rad_s = 0.0;
    return;
  }
  motion_.speed_mm_s = towards(motion_.speed_mm_s, wanted_mm_s_, config_.acceleration_mm_s2 * seconds);
  motion_.turn_rate_rad_s = towards(motion_.turn_rate_rad_s, wanted_rad_s_, config_.turn_acceleration_rad_s2 * seconds);
  const double heading = motion_.heading + 0.5 * motion_.turn_rate_rad_s * seconds;
  motion_.x_mm += motion_.speed_mm_s * seconds * repeatable::cos(heading);
  motion_.y_mm += motion_.speed_mm_s * seconds * repeatable::sin(heading);
  motion_.heading += motion_.turn_rate_rad_s * seconds;
}

BaseBytes BaseEmulator::report() const {
  MotorCounts counts;
  const double half_difference = motion_.turn_rate_rad_s * kWheelDistance_mm / 2;
  counts.moving = motion_.speed_mm_s != 0.0 || motion_.turn_rate_rad_s != 0.0;
  counts.x = position_count(motion_.x_mm, config_.subtype);
  counts.y = position_count(motion_.y_mm, config_.subtype);
  counts.heading = counts.control = count(motion_.heading / (2.0 * repeatable::kPi) * kHeadingCounts);
  counts.left = count((motion_.speed_mm_s - half_difference) / kWheelCount_mm_s);
  counts.right = count((motion_.speed_mm_s + half_difference) / kWheelCount_mm_s);
  counts.left_stall = counts.right_stall = blocked_ && motors_on_ && (wanted_mm_s_ != 0.0 || wanted_rad_s_ != 0.0);
  return motor_packet(counts);
}

}  // namespace scanway::simulator
