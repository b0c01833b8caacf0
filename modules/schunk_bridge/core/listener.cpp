#include "modules/schunk_bridge/core/listener.h"

#include "modules/schunk_bridge/core/fields.h"
#include "modules/schunk_bridge/core/powercube.h"

namespace scanway::schunk {
namespace {

/// What a state of that length holds when nobody heard what it was asked for.
std::uint8_t usual_mask(std::size_t bytes) {
  switch (bytes) {
    case 6:
      return state_mask::kPosition;
    case 10:
      return state_mask::kPosition | state_mask::kVelocity;
    case 14:
      return state_mask::kPosition | state_mask::kVelocity | state_mask::kCurrent;
    default:
      return 0;
  }
}

bool fits(std::uint8_t mask, std::size_t bytes) { return bytes == 2 + 4 * static_cast<std::size_t>(numbers_in(mask)); }

std::string kind_of(const Message& message, const Reply& reply) {
  if (std::holds_alternative<reply::Failure>(reply)) return "failure";
  const bool standing = std::holds_alternative<reply::Standing>(reply);
  return standing || std::holds_alternative<reply::Alert>(reply) || message.direction == Direction::error ? "impulse"
                                                                                                          : "answer";
}

bool holds_values_in_units(const Reply& reply) {
  const auto* setting = std::get_if<reply::SettingValue>(&reply);
  return std::holds_alternative<reply::State>(reply) || std::holds_alternative<reply::Standing>(reply) ||
         (setting && form_of(setting->setting) == SettingForm::value);
}

}  // namespace

Listener::Result Listener::add(const CanFrame& frame, std::size_t number, std::optional<Utime> utime) {
  Result result;
  if (!is_motion_protocol(frame.id)) {
    std::optional<Reading> reading = powercube::read(frame);
    if (!reading) reading = Reading{"other frame", "", 0, {{"bytes", hex_of(frame.bytes())}}, {}, {}};
    reading->utime = utime;
    reading->frames = {number};
    result.readings.push_back(std::move(*reading));
    return result;
  }
  MessageAssembler::Result assembled = assembler_.add(frame, number, utime.value_or(0));
  result.bad = std::move(assembled.bad);
  if (!assembled.message) return result;
  const Message& message = *assembled.message;
  Reading reading;
  reading.type = std::string(name_of(message.command));
  if (reading.type.empty())
    reading.type = "unknown command " + describe_code(static_cast<std::uint8_t>(message.command)).substr(0, 2);
  reading.module = message.module;
  reading.frames = message.frames;
  if (utime) reading.utime = message.utime;
  const bool asks = message.direction == Direction::to_module;
  const std::string fault = asks ? read_request(message, reading) : read_reply(message, reading);
  if (fault.empty()) {
    result.readings.push_back(std::move(reading));
  } else {
    result.bad.push_back({message.frames, fault});
  }
  return result;
}

std::string Listener::read_request(const Message& message, Reading& reading) {
  Module& module = module_of(message);
  auto fields = fields_of_request(message, module.units.value_or(UnitSystem::radian));
  if (!fields) {
    return reading.type + " with content that does not fit it (" + std::to_string(message.parameters.size()) +
           " bytes)";
  }
  if (message.command == Command::get_state && message.parameters.size() == 5) module.mask = message.parameters[4] & 7;
  reading.kind = "request";
  reading.fields = std::move(*fields);
  return {};
}

std::string Listener::read_reply(const Message& message, Reading& reading) {
  Module& module = module_of(message);
  const std::size_t bytes = message.parameters.size();
  // The first states after a change of the mask may still hold what the old one asked for.
  const std::uint8_t mask = module.mask && fits(*module.mask, bytes) ? *module.mask : usual_mask(bytes);
  const Reply reply = parse_reply(message, mask, module.units.value_or(UnitSystem::radian));
  if (const auto* malformed = std::get_if<reply::Malformed>(&reply)) return malformed->reason;
  if (const auto* setting = std::get_if<reply::SettingValue>(&reply);
      setting && setting->setting == Setting::unit_system) {
    const auto units = static_cast<UnitSystem>(setting->bytes[0]);
    if (is_known(units)) module.units = units;
  }
  reading.kind = kind_of(message, reply);
  reading.fields = fields_of(message, reply);
  if (module.units && holds_values_in_units(reply)) {
    reading.fields.push_back({"unit", std::string(name_of(*module.units))});
  }
  return {};
}

}  // namespace scanway::schunk
