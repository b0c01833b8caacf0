#include "modules/schunk_bridge/core/reply.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace scanway::schunk {
namespace {

using Bytes = std::span<const std::uint8_t>;

reply::Malformed wrong_length(const Message& message) {
  return {std::string(name_of(message.command)) + " with " + std::to_string(message.parameters.size()) +
          " bytes of content"};
}

reply::Malformed no_number(const Message& message) {
  return {std::string(name_of(message.command)) + " with a number that is none"};
}

bool says(Bytes bytes, std::string_view text) {
  return std::equal(bytes.begin(), bytes.end(), text.begin(), text.end());
}

bool begins_with_ok(Bytes bytes) { return bytes.size() >= 2 && says(bytes.first(2), "OK"); }

/// Text up to its first zero byte.
std::string text_of(Bytes bytes) { return {bytes.begin(), std::find(bytes.begin(), bytes.end(), 0)}; }

Reply parse_alert(const Message& message) {
  const Bytes bytes = message.parameters;
  // One byte is an error, a warning or the answer to a command; the impulse form of infos has two.
  if (bytes.size() == 1) return reply::Alert{bytes[0], true};
  if (bytes.size() == 2 && bytes[1] == 0) return reply::Alert{bytes[0], false};
  return wrong_length(message);
}

Reply parse_state(const Message& message, std::uint8_t mask, UnitSystem units) {
  Bytes bytes = message.parameters;
  if (bytes.size() != 2 + 4 * static_cast<std::size_t>(numbers_in(mask))) return wrong_length(message);
  reply::State state;
  const auto take = [&](std::uint8_t part, std::optional<double>& value, auto read) {
    if (!(mask & part)) return true;
    value = read(bytes.first(4), units);
    bytes = bytes.subspan(4);
    return std::isfinite(*value);
  };
  if (!take(state_mask::kPosition, state.position, read_number) ||
      !take(state_mask::kVelocity, state.velocity, read_number) ||
      !take(state_mask::kCurrent, state.current_A, read_amperes)) {
    return no_number(message);
  }
  state.bits = bytes[0];
  state.error = bytes[1];
  return state;
}

template <class T>
Reply parse_number(const Message& message, double (*read)(Bytes, UnitSystem), UnitSystem units) {
  if (message.parameters.size() != 4) return wrong_length(message);
  const double value = read(message.parameters, units);
  if (!std::isfinite(value)) return no_number(message);
  return T{value};
}

Reply parse_detailed_error(const Message& message) {
  const Bytes bytes = message.parameters;
  if (bytes.size() != 6) return wrong_length(message);
  const double data = static_cast<double>(read_float(bytes.subspan(2)));
  return reply::DetailedError{static_cast<Command>(bytes[0]), bytes[1], std::isfinite(data) ? data : 0.0};
}

constexpr std::size_t kModuleInfoBytes = 44;

reply::ModuleInfo parse_module_info(Bytes bytes) {
  reply::ModuleInfo info;
  info.type = text_of(bytes.first(8));
  info.order_number = read_unsigned(bytes.subspan(8, 4));
  info.firmware = read_unsigned(bytes.subspan(12, 2)) / 100.0;
  info.protocol = read_unsigned(bytes.subspan(14, 2)) / 100.0;
  info.hardware = read_unsigned(bytes.subspan(16, 2)) / 100.0;
  info.date = text_of(bytes.subspan(18, 21));
  return info;
}

Reply parse_setting(const Message& message, UnitSystem units) {
  const Bytes bytes = message.parameters;
  if (bytes.size() == kModuleInfoBytes) return parse_module_info(bytes);
  if (bytes.size() < 2) return wrong_length(message);
  const Bytes content = bytes.subspan(1);
  reply::SettingValue value{static_cast<Setting>(bytes[0]), 0, {content.begin(), content.end()}};
  const SettingForm form = form_of(value.setting);
  const std::size_t size = form == SettingForm::u8 ? 1 : form == SettingForm::u16 ? 2 : 4;
  if (form == SettingForm::bytes) return value;
  if (content.size() != size) return wrong_length(message);
  if (form == SettingForm::value) {
    value.value = read_number(content, units);
  } else {
    value.value = form == SettingForm::real ? static_cast<double>(read_float(content)) : read_unsigned(content);
  }
  if (!std::isfinite(value.value)) return no_number(message);
  return value;
}

Reply parse_setting_taken(const Message& message) {
  const Bytes bytes = message.parameters;
  if (bytes.size() != 3 || !begins_with_ok(bytes)) return wrong_length(message);
  return reply::SettingTaken{static_cast<Setting>(bytes[2])};
}

Reply parse_user(const Message& message) {
  const Bytes bytes = message.parameters;
  if (bytes.size() != 3 || !begins_with_ok(bytes)) return wrong_length(message);
  return reply::User{bytes[2]};
}

Reply parse_impulses(const Message& message) {
  if (says(message.parameters, "ON")) return reply::Impulses{true};
  if (says(message.parameters, "OFF")) return reply::Impulses{false};
  return wrong_length(message);
}

Reply parse_ok(const Message& message) {
  if (says(message.parameters, "OK")) return reply::Ok{};
  return wrong_length(message);
}

}  // namespace

int numbers_in(std::uint8_t mask) { return (mask & 1) + ((mask >> 1) & 1) + ((mask >> 2) & 1); }

Reply parse_reply(const Message& message, std::uint8_t mask, UnitSystem units) {
  const Bytes bytes = message.parameters;
  switch (message.command) {
    case Command::cmd_error:
    case Command::cmd_warning:
    case Command::cmd_info:
      return parse_alert(message);
    default:
      break;
  }
  if (bytes.size() == 1) return reply::Failure{bytes[0]};
  switch (message.command) {
    case Command::get_config:
      return parse_setting(message, units);
    case Command::set_config:
      return parse_setting_taken(message);
    case Command::change_user:
      return parse_user(message);
    case Command::cmd_toggle_impulse_message:
      return parse_impulses(message);
    case Command::get_detailed_error_info:
      return parse_detailed_error(message);
    case Command::cmd_move_blocked:
    case Command::cmd_pos_reached:
      return parse_number<reply::Standing>(message, read_number, units);
    default:
      break;
  }
  if (says(bytes, "OK")) return reply::Ok{};  // Now and then GET STATE is answered so, too.
  switch (message.command) {
    case Command::get_state:
      return parse_state(message, mask, units);
    case Command::move_pos:
    case Command::move_pos_rel:
    case Command::move_pos_time:
    case Command::move_pos_time_rel:
      return parse_number<reply::Duration>(message, read_seconds, units);
    case Command::get_config_ext:
    case Command::set_config_ext:
    case Command::set_target_pos:
    case Command::set_target_pos_rel:
    case Command::check_mc_pc_communication:
    case Command::check_pc_mc_communication:
      return reply::Unexplained{};
    default:
      break;
  }
  return name_of(message.command).empty() ? Reply(reply::Unexplained{}) : parse_ok(message);
}

}  // namespace scanway::schunk
