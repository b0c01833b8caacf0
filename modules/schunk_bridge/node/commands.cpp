#include "modules/schunk_bridge/node/commands.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace scanway::schunk {
namespace {

using Order = pan_tilt_command_t;

bool is_said(double value) { return !std::isnan(value); }
double said_or(double value, double otherwise) { return is_said(value) ? value : otherwise; }

std::string sweep(const Order& command, PanTilt& pan_tilt, const SweepConfig& configured, Utime now) {
  SweepConfig config = configured;
  config.tilt = said_or(command.tilt_rad, config.tilt);
  config.speed = said_or(command.pan_speed_rad_s, config.speed);
  pan_tilt.sweep().set_config(config);
  return pan_tilt.start_sweep(now);
}

std::string move(const Order& command, PanTilt& pan_tilt, const SweepConfig& configured, Utime now) {
  const auto speed = [&](double said, const Axis& axis) {
    return said_or(said, std::min(configured.travel_speed, axis.max_speed()));
  };
  if (!is_said(command.pan_rad) && !is_said(command.tilt_rad)) return "it says no angle";
  std::string refusal;
  if (is_said(command.pan_rad)) {
    refusal = pan_tilt.move_pan(command.pan_rad, speed(command.pan_speed_rad_s, pan_tilt.pan()), now);
  }
  if (refusal.empty() && is_said(command.tilt_rad)) {
    refusal = pan_tilt.move_tilt(command.tilt_rad, speed(command.tilt_speed_rad_s, pan_tilt.tilt()), now);
  }
  return refusal;
}

std::string turn(const Order& command, PanTilt& pan_tilt, Utime now) {
  if (!is_said(command.pan_speed_rad_s) && !is_said(command.tilt_speed_rad_s)) return "it says no speed";
  std::string refusal;
  if (is_said(command.pan_speed_rad_s)) refusal = pan_tilt.turn_pan(command.pan_speed_rad_s, now);
  if (refusal.empty() && is_said(command.tilt_speed_rad_s)) {
    refusal = pan_tilt.turn_tilt(command.tilt_speed_rad_s, now);
  }
  return refusal;
}

}  // namespace

std::string command_name(std::int8_t command) {
  static constexpr const char* kNames[] = {"SWEEP", "MOVE",      "VELOCITY",   "REFERENCE",
                                           "STOP",  "FAST_STOP", "ACKNOWLEDGE"};
  const bool known = command >= 0 && command < static_cast<std::int8_t>(std::size(kNames));
  return known ? kNames[command] : "command " + std::to_string(command);
}

std::string carry_out(const Order& command, PanTilt& pan_tilt, const SweepConfig& configured, Utime now) {
  switch (command.command) {
    case Order::SWEEP:
      return sweep(command, pan_tilt, configured, now);
    case Order::MOVE:
      return move(command, pan_tilt, configured, now);
    case Order::VELOCITY:
      return turn(command, pan_tilt, now);
    case Order::REFERENCE:
      return pan_tilt.reference(now);
    case Order::STOP:
      pan_tilt.stop(now);
      return {};
    case Order::FAST_STOP:
      pan_tilt.fast_stop(now);
      return {};
    case Order::ACKNOWLEDGE:
      return pan_tilt.acknowledge();
    default:
      return "there is no such command";
  }
}

}  // namespace scanway::schunk
