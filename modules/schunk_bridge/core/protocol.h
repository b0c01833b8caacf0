#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

/// The words of the SCHUNK Motion Protocol, by SCHUNK's own names (SCHUNK Motion manual v1.41).
namespace scanway::schunk {

/// What a message asks for or answers to.
enum class Command : std::uint8_t {
  get_config = 0x80,
  set_config = 0x81,
  get_config_ext = 0x82,
  set_config_ext = 0x83,
  fragment_first = 0x84,
  fragment_middle = 0x85,
  fragment_last = 0x86,
  fragment_ack = 0x87,
  cmd_error = 0x88,
  cmd_warning = 0x89,
  cmd_info = 0x8A,
  cmd_ack = 0x8B,
  cmd_fast_stop = 0x90,
  cmd_stop = 0x91,
  cmd_reference = 0x92,
  cmd_move_blocked = 0x93,
  cmd_pos_reached = 0x94,
  get_state = 0x95,
  get_detailed_error_info = 0x96,
  set_target_vel = 0xA0,
  set_target_acc = 0xA1,
  set_target_jerk = 0xA2,
  set_target_cur = 0xA3,
  set_target_time = 0xA4,
  set_target_pos = 0xA6,
  set_target_pos_rel = 0xA7,
  move_pos = 0xB0,
  move_pos_time = 0xB1,
  move_cur = 0xB3,
  move_vel = 0xB5,
  move_grip = 0xB7,
  move_pos_rel = 0xB8,
  move_pos_time_rel = 0xB9,
  cmd_reboot = 0xE0,
  change_user = 0xE3,
  check_mc_pc_communication = 0xE4,
  check_pc_mc_communication = 0xE5,
  cmd_toggle_impulse_message = 0xE7,
};

/// "MOVE POS"; empty for a command that the protocol does not have.
std::string_view name_of(Command command);

/// "FAST STOP" for D9; empty for a code that the protocol does not have. Infos, warnings and errors share the codes.
std::string_view name_of_code(std::uint8_t code);
/// "D9 FAST STOP", or "42 (unknown code)".
std::string describe_code(std::uint8_t code);
/// Whether an acknowledgement clears the error on hardware; of the others the cause has to be mended first.
bool clears_by_acknowledgement(std::uint8_t code);
/// What a user can do about an error; empty if there is nothing to say.
std::string_view advice_on_code(std::uint8_t code);

/// The bits of a module's state.
namespace state_bit {
inline constexpr std::uint8_t kReferenced = 0x01;
inline constexpr std::uint8_t kMoving = 0x02;
inline constexpr std::uint8_t kProgramMode = 0x04;
inline constexpr std::uint8_t kWarning = 0x08;
inline constexpr std::uint8_t kError = 0x10;
inline constexpr std::uint8_t kBrakeApplied = 0x20;
inline constexpr std::uint8_t kMoveEnd = 0x40;
inline constexpr std::uint8_t kPositionReached = 0x80;
}  // namespace state_bit

/// The name of each bit, lowest first.
std::span<const std::string_view, 8> state_bit_names();

/// What GET STATE may be asked to add to state and error.
namespace state_mask {
inline constexpr std::uint8_t kPosition = 0x01;
inline constexpr std::uint8_t kVelocity = 0x02;
inline constexpr std::uint8_t kCurrent = 0x04;
}  // namespace state_mask

/// Settings that GET CONFIG and SET CONFIG know.
enum class Setting : std::uint8_t {
  module_id = 0x01,
  group_id = 0x02,
  serial_baud = 0x03,
  can_baud = 0x04,
  communication_mode = 0x05,
  unit_system = 0x06,
  soft_high = 0x07,
  soft_low = 0x08,
  max_velocity = 0x09,
  max_acceleration = 0x0A,
  max_current = 0x0B,
  nominal_current = 0x0C,
  max_jerk = 0x0D,
  phase_offset_a = 0x0E,
  phase_offset_b = 0x0F,
  data_crc = 0x13,
  reference_offset = 0x14,
  serial_number = 0x15,
  order_number = 0x16,
  gear_ratio = 0x18,
  eeprom = 0xFE,
};

/// How a setting's value is coded.
enum class SettingForm { u8, u16, u32, value, real, bytes };  ///< value: in the unit system; real: float32 always.

std::string_view name_of(Setting setting);  ///< "max_velocity"; empty if there is no such setting.
SettingForm form_of(Setting setting);

}  // namespace scanway::schunk
