#include "modules/sick_bridge/core/commands.h"

#include "modules/sick_bridge/core/parameters.h"

namespace scanway::sick {
namespace {

constexpr std::uint8_t kAuthorisedClient = 3;
constexpr std::uint32_t kAuthorisedClientHash = 0xF4724744;

Request make_request(std::string_view command, std::string_view answer, std::string_view name,
                     const ParameterWriter& parameters) {
  std::string body = std::string(command) + ' ' + std::string(name);
  if (!parameters.str().empty()) body += ' ' + parameters.str();
  return {std::string(answer), std::string(name), make_frame(parameters.dialect(), body)};
}

Request write_variable(std::string_view name, const ParameterWriter& parameters) {
  return make_request("sWN", "sWA", name, parameters);
}

Request call(std::string_view name, const ParameterWriter& parameters) {
  return make_request("sMN", "sAN", name, parameters);
}

}  // namespace

Request read_variable(Dialect dialect, std::string_view name) {
  return make_request("sRN", "sRA", name, ParameterWriter(dialect));
}

Request call_method(Dialect dialect, std::string_view name) { return call(name, ParameterWriter(dialect)); }

Request subscribe(Dialect dialect, std::string_view event, bool on) {
  return make_request("sEN", "sEA", event, ParameterWriter(dialect).hex(on ? 1 : 0, 1));
}

Request log_in(Dialect dialect) {
  return call("SetAccessMode", ParameterWriter(dialect).byte(kAuthorisedClient).hex(kAuthorisedClientHash, 4));
}

Request set_scan_config(Dialect dialect, const ScanConfig& config) {
  return call("mLMPsetscancfg", ParameterWriter(dialect)
                                    .decimal(config.frequency, 4)
                                    .decimal(1, 2)  // Number of scan areas.
                                    .decimal(config.resolution, 4)
                                    .decimal(config.start_angle, 4)
                                    .decimal(config.stop_angle, 4));
}

Request set_echo_filter(Dialect dialect, EchoFilter filter) {
  return write_variable("FREchoFilter", ParameterWriter(dialect).hex(static_cast<int>(filter), 1));
}

Request set_scan_content(Dialect dialect, const ScanContent& content) {
  return write_variable("LMDscandatacfg", ParameterWriter(dialect)
                                              .bits(content.channels)
                                              .hex(content.rssi, 1)
                                              .hex(content.rssi_16_bit, 1)
                                              .hex(0, 1)  // Unit of the remission: digits.
                                              .bits(content.encoders)
                                              .hex(content.position, 1)
                                              .hex(content.device_name, 1)
                                              .hex(content.comment, 1)
                                              .hex(content.date, 1)
                                              .decimal(content.every, 2));
}

Request set_output_range(Dialect dialect, const ScanConfig& range) {
  return write_variable("LMPoutputRange", ParameterWriter(dialect)
                                              .hex(1, 2)  // Number of ranges.
                                              .hex(range.resolution, 4)
                                              .hex(range.start_angle, 4)
                                              .hex(range.stop_angle, 4));
}

Request set_host_dialect(Dialect dialect, Dialect wanted) {
  return write_variable("EIHstCola", ParameterWriter(dialect).hex(wanted == Dialect::cola_b, 1));
}

Request set_encoder_source(Dialect dialect, bool encoder) {
  return write_variable("LICsrc", ParameterWriter(dialect).hex(encoder, 1));
}

Request set_encoder_setting(Dialect dialect, std::uint8_t setting) {
  return write_variable("LICencset", ParameterWriter(dialect).hex(setting, 1));
}

Request set_encoder_resolution(Dialect dialect, float mm_per_tick) {
  return write_variable("LICencres", ParameterWriter(dialect).f32(mm_per_tick));
}

Request set_date(Dialect dialect, const DeviceDate& date) {
  return call("LSPsetdatetime", ParameterWriter(dialect)
                                    .decimal(date.year, 2)
                                    .decimal(date.month, 1)
                                    .decimal(date.day, 1)
                                    .decimal(date.hour, 1)
                                    .decimal(date.minute, 1)
                                    .decimal(date.second, 1)
                                    .decimal(date.microsecond, 4));
}

}  // namespace scanway::sick
