#include "modules/schunk_bridge/core/request.h"

#include <utility>

namespace scanway::schunk::request {
namespace {

Message make(std::uint8_t module, Command command, std::vector<std::uint8_t> parameters = {}) {
  Message message;
  message.direction = Direction::to_module;
  message.module = module;
  message.command = command;
  message.parameters = std::move(parameters);
  return message;
}

}  // namespace

Message plain(std::uint8_t module, Command command) { return make(module, command); }

Message get_config(std::uint8_t module, Setting setting) {
  return make(module, Command::get_config, {static_cast<std::uint8_t>(setting)});
}

Message set_config(std::uint8_t module, Setting setting, double value, UnitSystem units) {
  std::vector<std::uint8_t> parameters = {static_cast<std::uint8_t>(setting)};
  const auto whole = static_cast<std::uint32_t>(value);
  switch (form_of(setting)) {
    case SettingForm::u8:
      append_unsigned(parameters, whole, 1);
      break;
    case SettingForm::u16:
      append_unsigned(parameters, whole, 2);
      break;
    case SettingForm::u32:
      append_unsigned(parameters, whole, 4);
      break;
    case SettingForm::value:
      append_number(parameters, value, units);
      break;
    case SettingForm::real:
      append_float(parameters, static_cast<float>(value));
      break;
    case SettingForm::bytes:
      break;
  }
  return make(module, Command::set_config, std::move(parameters));
}

Message get_state(std::uint8_t module, double period_s, std::uint8_t mask, UnitSystem units) {
  std::vector<std::uint8_t> parameters;
  append_seconds(parameters, period_s, units);
  parameters.push_back(mask);
  return make(module, Command::get_state, std::move(parameters));
}

Message with_values(std::uint8_t module, Command command, std::initializer_list<double> values, UnitSystem units) {
  std::vector<std::uint8_t> parameters;
  for (const double value : values) append_number(parameters, value, units);
  return make(module, command, std::move(parameters));
}

Message with_current(std::uint8_t module, Command command, double amperes, UnitSystem units) {
  std::vector<std::uint8_t> parameters;
  append_amperes(parameters, amperes, units);
  return make(module, command, std::move(parameters));
}

Message set_target_time(std::uint8_t module, double seconds, UnitSystem units) {
  std::vector<std::uint8_t> parameters;
  append_seconds(parameters, seconds, units);
  return make(module, Command::set_target_time, std::move(parameters));
}

}  // namespace scanway::schunk::request
