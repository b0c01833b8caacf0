#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "modules/base_bridge/core/packet.h"

namespace scanway::erratic {

/// What the host can ask for, by the names of the protocol sheet.
enum class Command : std::uint8_t {
  pulse = 0,
  open_controller = 1,
  close_controller = 2,
  enable_motors = 4,
  set_max_trans_acc = 5,
  set_max_position_velocity = 6,
  reset_origo = 7,
  trans_vel = 11,
  rot_pos = 12,
  rot_dpos = 13,
  configuration = 18,
  rot_vel = 21,
  set_max_rot_acc = 23,
  set_sonar = 28,
  stop = 29,
  wheel_vel = 32,
  set_analog = 71,
  save_config = 72,
  set_pwm_freq = 73,
  set_pwm_max_on = 74,
  servo_pos = 75,
  trans_pid_p = 80,
  trans_pid_v = 81,
  trans_pid_i = 82,
  rot_pid_p = 83,
  rot_pid_v = 84,
  rot_pid_i = 85,
};

/// "trans_vel"; empty for a number that is no command.
std::string_view name_of(Command command);

/// Packets, ready to be sent.
using Packet = std::vector<std::uint8_t>;

Packet make_command(Command command);
/// With a whole number; beyond 65535 either way it is the nearest that can be sent.
Packet make_command(Command command, int value);
/// wheel_vel: in steps of 20 mm/s, at most 126 of them.
Packet make_wheel_velocities(int left_mm_s, int right_mm_s);
/// Servo 0 to 255 to a position in counts (1100 to 2300, 6.5 a degree).
Packet make_servo_position(std::uint8_t servo, std::uint16_t counts);
Packet make_save_config();

/// A command read back.
struct ReadCommand {
  Command command{};
  std::optional<int> value;           ///< Of a command with a number.
  std::vector<std::uint8_t> content;  ///< Any other argument: a string without its length, the wheels' two bytes.
};

/// What a payload asks for; nothing when it is no command.
std::optional<ReadCommand> read_command(Bytes payload);

}  // namespace scanway::erratic
