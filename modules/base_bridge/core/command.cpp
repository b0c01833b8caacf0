#include "modules/base_bridge/core/command.h"

#include <algorithm>
#include <array>
#include <cstdlib>

namespace scanway::erratic {
namespace {

constexpr std::uint8_t kPositive = 0x3B, kNegative = 0x1B, kString = 0x2B;

struct CommandName {
  Command command;
  std::string_view name;
};

constexpr CommandName kCommands[] = {
    {Command::pulse, "pulse"},
    {Command::open_controller, "open_controller"},
    {Command::close_controller, "close_controller"},
    {Command::enable_motors, "enable_motors"},
    {Command::set_max_trans_acc, "set_max_trans_acc"},
    {Command::set_max_position_velocity, "set_max_position_velocity"},
    {Command::reset_origo, "reset_origo"},
    {Command::trans_vel, "trans_vel"},
    {Command::rot_pos, "rot_pos"},
    {Command::rot_dpos, "rot_dpos"},
    {Command::configuration, "configuration"},
    {Command::rot_vel, "rot_vel"},
    {Command::set_max_rot_acc, "set_max_rot_acc"},
    {Command::set_sonar, "set_sonar"},
    {Command::stop, "stop"},
    {Command::wheel_vel, "wheel_vel"},
    {Command::set_analog, "set_analog"},
    {Command::save_config, "save_config"},
    {Command::set_pwm_freq, "set_pwm_freq"},
    {Command::set_pwm_max_on, "set_pwm_max_on"},
    {Command::servo_pos, "servo_pos"},
    {Command::trans_pid_p, "trans_pid_p"},
    {Command::trans_pid_v, "trans_pid_v"},
    {Command::trans_pid_i, "trans_pid_i"},
    {Command::rot_pid_p, "rot_pid_p"},
    {Command::rot_pid_v, "rot_pid_v"},
    {Command::rot_pid_i, "rot_pid_i"},
};

std::uint8_t low(unsigned value) { return static_cast<std::uint8_t>(value & 0xFF); }
std::uint8_t high(unsigned value) { return static_cast<std::uint8_t>(value >> 8 & 0xFF); }

std::uint8_t wheel_steps(int mm_s) { return static_cast<std::uint8_t>(std::clamp(mm_s / 20, -126, 126)); }

}  // namespace

std::string_view name_of(Command command) {
  for (const CommandName& known : kCommands) {
    if (known.command == command) return known.name;
  }
  return {};
}

Packet make_command(Command command) { return make_packet(std::array{static_cast<std::uint8_t>(command)}); }

Packet make_command(Command command, int value) {
  const auto magnitude = static_cast<unsigned>(std::min(std::abs(std::max(value, -65535)), 65535));
  const std::uint8_t type = value < 0 ? kNegative : kPositive;
  return make_packet(std::array{static_cast<std::uint8_t>(command), type, low(magnitude), high(magnitude)});
}

Packet make_wheel_velocities(int left_mm_s, int right_mm_s) {
  return make_packet(std::array{static_cast<std::uint8_t>(Command::wheel_vel), kPositive, wheel_steps(right_mm_s),
                                wheel_steps(left_mm_s)});
}

Packet make_servo_position(std::uint8_t servo, std::uint16_t counts) {
  return make_packet(std::array{static_cast<std::uint8_t>(Command::servo_pos), kString, std::uint8_t{3}, servo,
                                low(counts), high(counts)});
}

Packet make_save_config() {
  return make_packet(std::array<std::uint8_t, 4>{static_cast<std::uint8_t>(Command::save_config), 0, 0, 0});
}

std::optional<ReadCommand> read_command(Bytes payload) {
  if (payload.empty()) return std::nullopt;
  ReadCommand read;
  read.command = static_cast<Command>(payload[0]);
  if (name_of(read.command).empty()) return std::nullopt;
  if (payload.size() == 1) return read;
  const std::uint8_t type = payload[1];
  if (type == kString && payload.size() >= 3 && payload.size() == 3u + payload[2]) {
    read.content.assign(payload.begin() + 3, payload.end());
    return read;
  }
  const bool number = type == kPositive || type == kNegative;
  const bool raw = type == 0 && read.command == Command::save_config;
  if (payload.size() != 4 || !(number || raw)) return std::nullopt;
  if (raw || read.command == Command::wheel_vel) {
    read.content.assign(payload.begin() + 2, payload.end());
  } else {
    const int magnitude = payload[2] | payload[3] << 8;
    read.value = type == kNegative ? -magnitude : magnitude;
  }
  return read;
}

}  // namespace scanway::erratic
