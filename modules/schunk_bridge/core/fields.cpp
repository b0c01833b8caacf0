#include "modules/schunk_bridge/core/fields.h"

#include <cmath>
#include <span>

namespace scanway::schunk {
namespace {

using Bytes = std::span<const std::uint8_t>;
using Fields = std::vector<Field>;

Field whole(std::string name, std::int64_t value) { return {std::move(name), value}; }
Field number(std::string name, double value) { return {std::move(name), value}; }
Field text(std::string name, std::string value) { return {std::move(name), std::move(value)}; }

std::string setting_name(Setting setting) {
  const std::string_view name = name_of(setting);
  return name.empty() ? "setting_" + std::to_string(static_cast<int>(setting)) : std::string(name);
}

Fields code_fields(std::uint8_t code) {
  return {text("code", describe_code(code).substr(0, 2)), text("name", std::string(name_of_code(code)))};
}

Fields state_fields(const reply::State& state) {
  Fields fields;
  if (state.position) fields.push_back(number("position", *state.position));
  if (state.velocity) fields.push_back(number("velocity", *state.velocity));
  if (state.current_A) fields.push_back(number("current_A", *state.current_A));
  std::vector<std::string> bits;
  for (int bit = 0; bit < 8; ++bit) {
    if (state.bits & (1 << bit)) bits.emplace_back(state_bit_names()[static_cast<std::size_t>(bit)]);
  }
  fields.push_back({"state", std::move(bits)});
  fields.push_back(state.error == 0 ? Field{"error", {}} : text("error", describe_code(state.error)));
  return fields;
}

Fields setting_fields(const reply::SettingValue& value) {
  Fields fields = {text("setting", setting_name(value.setting))};
  if (form_of(value.setting) == SettingForm::bytes) {
    fields.push_back(text("bytes", hex_of(value.bytes)));
  } else if (value.setting == Setting::unit_system) {
    const auto units = static_cast<UnitSystem>(value.bytes[0]);
    fields.push_back(whole("value", value.bytes[0]));
    fields.push_back(text("name", std::string(name_of(units))));
  } else {
    const SettingForm form = form_of(value.setting);
    const bool real = form == SettingForm::value || form == SettingForm::real;
    fields.push_back(real ? number("value", value.value) : whole("value", static_cast<std::int64_t>(value.value)));
  }
  return fields;
}

Fields info_fields(const reply::ModuleInfo& info) {
  return {text("module_type", info.type),    whole("order_number", info.order_number),
          number("firmware", info.firmware), number("protocol", info.protocol),
          number("hardware", info.hardware), text("date", info.date)};
}

struct FieldsOf {
  const Message& message;
  Fields operator()(const reply::Ok&) const { return {{"ok", true}}; }
  Fields operator()(const reply::Failure& failure) const { return code_fields(failure.code); }
  Fields operator()(const reply::Alert& alert) const { return code_fields(alert.code); }
  Fields operator()(const reply::State& state) const { return state_fields(state); }
  Fields operator()(const reply::Duration& duration) const { return {number("seconds", duration.seconds)}; }
  Fields operator()(const reply::Standing& standing) const { return {number("position", standing.position)}; }
  Fields operator()(const reply::DetailedError& error) const {
    Fields fields = code_fields(error.code);
    fields.insert(fields.begin(), text("class", std::string(name_of(error.kind))));
    fields.push_back(number("data", error.data));
    return fields;
  }
  Fields operator()(const reply::SettingValue& value) const { return setting_fields(value); }
  Fields operator()(const reply::SettingTaken& taken) const { return {text("setting", setting_name(taken.setting))}; }
  Fields operator()(const reply::ModuleInfo& info) const { return info_fields(info); }
  Fields operator()(const reply::Impulses& impulses) const { return {{"impulses", impulses.on}}; }
  Fields operator()(const reply::User& user) const { return {whole("user", user.level)}; }
  Fields operator()(const reply::Unexplained&) const { return {text("bytes", hex_of(message.parameters))}; }
  Fields operator()(const reply::Malformed&) const { return {}; }
};

/// The values of a move or target, one after the other as far as they go.
std::optional<Fields> value_fields(const Message& message, UnitSystem units, std::initializer_list<const char*> names) {
  Bytes bytes = message.parameters;
  Fields fields;
  for (const char* name : names) {
    if (bytes.size() < 4) break;
    const std::string_view is = name;
    const double value = is == "current_A" ? read_amperes(bytes, units)
                         : is == "seconds" ? read_seconds(bytes, units)
                                           : read_number(bytes, units);
    if (!std::isfinite(value)) return std::nullopt;
    fields.push_back(number(name, value));
    bytes = bytes.subspan(4);
  }
  if (fields.empty() || !bytes.empty()) return std::nullopt;
  return fields;
}

std::optional<Fields> state_request_fields(const Message& message, UnitSystem units) {
  const Bytes bytes = message.parameters;
  if (bytes.empty()) return Fields{};
  if (bytes.size() != 5) return std::nullopt;
  const double period = read_seconds(bytes, units);
  if (!std::isfinite(period)) return std::nullopt;
  return Fields{number("period_s", period), {"mask", names_in_mask(bytes[4])}};
}

/// GET CONFIG and SET CONFIG: the setting, and its value when one is set.
std::optional<Fields> setting_request_fields(const Message& message, UnitSystem units) {
  const bool sets = message.command == Command::set_config;
  if (message.parameters.empty() && !sets) return Fields{};
  if (message.parameters.size() == 1 && !sets) {
    return Fields{text("setting", setting_name(static_cast<Setting>(message.parameters[0])))};
  }
  if (!sets || message.parameters.size() < 2) return std::nullopt;
  Message answer = message;  // SET CONFIG carries a setting just as the answer to GET CONFIG does.
  answer.command = Command::get_config;
  const Reply reply = parse_reply(answer, 0, units);
  if (!std::holds_alternative<reply::SettingValue>(reply)) return std::nullopt;
  return fields_of(answer, reply);
}

}  // namespace

std::string hex_of(std::span<const std::uint8_t> bytes) {
  constexpr std::string_view digits = "0123456789ABCDEF";
  std::string text;
  for (const std::uint8_t byte : bytes) {
    if (!text.empty()) text += ' ';
    text += digits[byte >> 4];
    text += digits[byte & 15];
  }
  return text;
}

std::vector<std::string> names_in_mask(std::uint8_t mask) {
  std::vector<std::string> names;
  if (mask & state_mask::kPosition) names.emplace_back("position");
  if (mask & state_mask::kVelocity) names.emplace_back("velocity");
  if (mask & state_mask::kCurrent) names.emplace_back("current");
  return names;
}

Fields fields_of(const Message& message, const Reply& reply) { return std::visit(FieldsOf{message}, reply); }

std::optional<Fields> fields_of_request(const Message& message, UnitSystem units) {
  switch (message.command) {
    case Command::get_state:
      return state_request_fields(message, units);
    case Command::get_config:
    case Command::set_config:
      return setting_request_fields(message, units);
    case Command::move_pos:
    case Command::move_pos_rel:
      return value_fields(message, units, {"position", "velocity", "acceleration", "current_A", "jerk"});
    case Command::move_pos_time:
    case Command::move_pos_time_rel:
      return value_fields(message, units, {"position", "velocity", "acceleration", "current_A", "seconds"});
    case Command::move_vel:
      return value_fields(message, units, {"velocity", "current_A"});
    case Command::move_cur:
    case Command::set_target_cur:
      return value_fields(message, units, {"current_A"});
    case Command::set_target_vel:
      return value_fields(message, units, {"velocity"});
    case Command::set_target_acc:
      return value_fields(message, units, {"acceleration"});
    case Command::set_target_jerk:
      return value_fields(message, units, {"jerk"});
    case Command::set_target_time:
      return value_fields(message, units, {"seconds"});
    case Command::set_target_pos:
    case Command::set_target_pos_rel:
      return value_fields(message, units, {"position"});
    case Command::change_user:
      return Fields{whole("password_bytes", static_cast<int>(message.parameters.size()))};
    default:
      break;
  }
  if (message.parameters.empty()) return Fields{};
  return Fields{text("bytes", hex_of(message.parameters))};
}

}  // namespace scanway::schunk
