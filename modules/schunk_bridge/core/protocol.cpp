#include "modules/schunk_bridge/core/protocol.h"

#include <algorithm>
#include <array>
#include <iterator>

namespace scanway::schunk {
namespace {

struct CommandName {
  Command command;
  std::string_view name;
};

constexpr CommandName kCommands[] = {
    {Command::get_config, "GET CONFIG"},
    {Command::set_config, "SET CONFIG"},
    {Command::get_config_ext, "GET CONFIG EXT"},
    {Command::set_config_ext, "SET CONFIG EXT"},
    {Command::fragment_first, "FRAG START"},
    {Command::fragment_middle, "FRAG MIDDLE"},
    {Command::fragment_last, "FRAG END"},
    {Command::fragment_ack, "FRAG ACK"},
    {Command::cmd_error, "CMD ERROR"},
    {Command::cmd_warning, "CMD WARNING"},
    {Command::cmd_info, "CMD INFO"},
    {Command::cmd_ack, "CMD ACK"},
    {Command::cmd_fast_stop, "CMD FAST STOP"},
    {Command::cmd_stop, "CMD STOP"},
    {Command::cmd_reference, "CMD REFERENCE"},
    {Command::cmd_move_blocked, "CMD MOVE BLOCKED"},
    {Command::cmd_pos_reached, "CMD POS REACHED"},
    {Command::get_state, "GET STATE"},
    {Command::get_detailed_error_info, "GET DETAILED ERROR INFO"},
    {Command::set_target_vel, "SET TARGET VEL"},
    {Command::set_target_acc, "SET TARGET ACC"},
    {Command::set_target_jerk, "SET TARGET JERK"},
    {Command::set_target_cur, "SET TARGET CUR"},
    {Command::set_target_time, "SET TARGET TIME"},
    {Command::set_target_pos, "SET TARGET POS"},
    {Command::set_target_pos_rel, "SET TARGET POS REL"},
    {Command::move_pos, "MOVE POS"},
    {Command::move_pos_time, "MOVE POS TIME"},
    {Command::move_cur, "MOVE CUR"},
    {Command::move_vel, "MOVE VEL"},
    {Command::move_grip, "MOVE GRIP"},
    {Command::move_pos_rel, "MOVE POS REL"},
    {Command::move_pos_time_rel, "MOVE POS TIME REL"},
    {Command::cmd_reboot, "CMD REBOOT"},
    {Command::change_user, "CHANGE USER"},
    {Command::check_mc_pc_communication, "CHECK MC PC COMMUNICATION"},
    {Command::check_pc_mc_communication, "CHECK PC MC COMMUNICATION"},
    {Command::cmd_toggle_impulse_message, "CMD TOGGLE IMPULSE MESSAGE"},
};

struct Code {
  std::uint8_t code;
  std::string_view name;
  bool clears_by_acknowledgement = false;
  std::string_view advice = {};
};

constexpr std::string_view kMendSupply = "check the supply voltage, then acknowledge";
constexpr std::string_view kLetCool = "let the module come to its temperature range, then acknowledge";
constexpr std::string_view kService = "restart the module; if it stays, the module needs service";
constexpr std::string_view kAtLimit = "acknowledge, then move away from the limit";
constexpr std::string_view kLoad = "free the axis and check its load, then acknowledge";
constexpr std::string_view kBus = "check cable, termination and bit rate of the CAN bus";

constexpr Code kCodes[] = {
    {0x01, "BOOT"},
    {0x02, "NO FREE SPACE"},
    {0x03, "NO RIGHTS"},
    {0x04, "UNKNOWN COMMAND"},
    {0x05, "FAILED"},
    {0x06, "NOT REFERENCED", false, "send the axis to its reference first"},
    {0x07, "SEARCH SINE VECTOR"},
    {0x08, "NO ERROR"},
    {0x09, "COMMUNICATION ERROR", false, kBus},
    {0x10, "TIMEOUT"},
    {0x11, "UNKNOWN AXIS ID"},
    {0x16, "WRONG BAUD RATE"},
    {0x19, "CHECKSUM"},
    {0x1B, "VALUE ABOVE LIMIT"},
    {0x1D, "MESSAGE LENGTH"},
    {0x1E, "WRONG PARAMETER"},
    {0x1F, "PROGRAM END"},
    {0x40, "TRIGGER"},
    {0x41, "READY"},
    {0x42, "GUI CONNECTED"},
    {0x43, "GUI DISCONNECTED"},
    {0x44, "PROGRAM CHANGED"},
    {0x70, "TEMP LOW", false, kLetCool},
    {0x71, "TEMP HIGH", false, kLetCool},
    {0x72, "LOGIC LOW", false, kMendSupply},
    {0x73, "LOGIC HIGH", false, kMendSupply},
    {0x74, "MOTOR VOLTAGE LOW", false, kMendSupply},
    {0x75, "MOTOR VOLTAGE HIGH", false, kMendSupply},
    {0x76, "CABLE BREAK", false, "check the cables of the module, then acknowledge"},
    {0x78, "MOTOR TEMP", false, kLetCool},
    {0x82, "OVERSHOOT", true, kLoad},
    {0xC8, "WRONG RAMP TYPE", false, kService},
    {0xD2, "CONFIG MEMORY", false, kService},
    {0xD3, "PROGRAM MEMORY", false, kService},
    {0xD4, "INVALID PHRASE", false, kService},
    {0xD5, "SOFT LOW", true, kAtLimit},
    {0xD6, "SOFT HIGH", true, kAtLimit},
    {0xD7, "PRESSURE", false, kService},
    {0xD8, "SERVICE", false, kService},
    {0xD9, "FAST STOP", true, "acknowledge when the axis may move again"},
    {0xDA, "TOW", true, kLoad},
    {0xDB, "VPC3", false, kService},
    {0xDC, "FRAGMENTATION", false, kBus},
    {0xDD, "COMMUTATION", false, kService},
    {0xDE, "CURRENT", false, kLoad},
    {0xDF, "I2T", true, kLoad},
    {0xE0, "INITIALIZE", false, kService},
    {0xE1, "INTERNAL", false, kService},
    {0xE2, "HARD LOW", false, kAtLimit},
    {0xE3, "HARD HIGH", false, kAtLimit},
    {0xE4, "TOO FAST", true, kLoad},
    {0xE5, "RESOLVER CHECK FAILED", false, kService},  // One source says E5, another EB.
    {0xEB, "RESOLVER CHECK FAILED", false, kService},
    {0xEC, "MATH", false, kService},
};

struct SettingName {
  Setting setting;
  std::string_view name;
  SettingForm form;
};

constexpr SettingName kSettings[] = {
    {Setting::module_id, "module_id", SettingForm::u8},
    {Setting::group_id, "group_id", SettingForm::u8},
    {Setting::serial_baud, "serial_baud", SettingForm::u16},
    {Setting::can_baud, "can_baud_kbit_s", SettingForm::u16},
    {Setting::communication_mode, "communication_mode", SettingForm::u8},
    {Setting::unit_system, "unit_system", SettingForm::u8},
    {Setting::soft_high, "soft_high", SettingForm::value},
    {Setting::soft_low, "soft_low", SettingForm::value},
    {Setting::max_velocity, "max_velocity", SettingForm::value},
    {Setting::max_acceleration, "max_acceleration", SettingForm::value},
    {Setting::max_current, "max_current", SettingForm::value},
    {Setting::nominal_current, "nominal_current", SettingForm::value},
    {Setting::max_jerk, "max_jerk", SettingForm::value},
    {Setting::phase_offset_a, "phase_offset_a", SettingForm::u16},
    {Setting::phase_offset_b, "phase_offset_b", SettingForm::u16},
    {Setting::data_crc, "data_crc", SettingForm::u16},
    {Setting::reference_offset, "reference_offset", SettingForm::value},
    {Setting::serial_number, "serial_number", SettingForm::u32},
    {Setting::order_number, "order_number", SettingForm::u32},
    {Setting::gear_ratio, "gear_ratio", SettingForm::real},
    {Setting::eeprom, "eeprom", SettingForm::bytes},
};

const Code* find_code(std::uint8_t code) {
  const auto* found = std::find_if(std::begin(kCodes), std::end(kCodes), [&](const Code& c) { return c.code == code; });
  return found == std::end(kCodes) ? nullptr : found;
}

const SettingName* find_setting(Setting setting) {
  const auto* found = std::find_if(std::begin(kSettings), std::end(kSettings),
                                   [&](const SettingName& s) { return s.setting == setting; });
  return found == std::end(kSettings) ? nullptr : found;
}

std::string hex(std::uint8_t byte) {
  constexpr std::string_view digits = "0123456789ABCDEF";
  return {digits[byte >> 4], digits[byte & 15]};
}

}  // namespace

std::string_view name_of(Command command) {
  for (const CommandName& known : kCommands) {
    if (known.command == command) return known.name;
  }
  return {};
}

std::string_view name_of_code(std::uint8_t code) {
  const Code* found = find_code(code);
  return found ? found->name : std::string_view{};
}

std::string describe_code(std::uint8_t code) {
  const Code* found = find_code(code);
  return hex(code) + " " + (found ? std::string(found->name) : "(unknown code)");
}

bool clears_by_acknowledgement(std::uint8_t code) {
  const Code* found = find_code(code);
  return found && found->clears_by_acknowledgement;
}

std::string_view advice_on_code(std::uint8_t code) {
  const Code* found = find_code(code);
  return found ? found->advice : std::string_view{};
}

std::span<const std::string_view, 8> state_bit_names() {
  static constexpr std::array<std::string_view, 8> names = {
      "referenced", "moving", "program_mode", "warning", "error", "brake_applied", "move_end", "position_reached"};
  return names;
}

std::string_view name_of(Setting setting) {
  const SettingName* found = find_setting(setting);
  return found ? found->name : std::string_view{};
}

SettingForm form_of(Setting setting) {
  const SettingName* found = find_setting(setting);
  return found ? found->form : SettingForm::bytes;
}

}  // namespace scanway::schunk
