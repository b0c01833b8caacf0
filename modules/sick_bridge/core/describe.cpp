#include "modules/sick_bridge/core/describe.h"

#include <span>
#include <string_view>

#include "modules/sick_bridge/core/names.h"
#include "modules/sick_bridge/core/parameters.h"

namespace scanway::sick {
namespace {

enum class Type : std::uint8_t { u8, u16, u32, i32, f32, bits, text };

struct Parameter {
  const char* name;
  Type type;
  std::string (*meaning)(unsigned) = nullptr;  ///< The number in words.
};

struct Layout {
  std::string_view telegram;  ///< Command and name.
  std::span<const Parameter> parameters;
};

constexpr Parameter kLogin[] = {{"level", Type::u8}, {"password_hash", Type::u32}};
constexpr Parameter kSuccess[] = {{"accepted", Type::u8}};  // 1: yes.
constexpr Parameter kRefusal[] = {{"refused", Type::u8}};   // 0: no.
constexpr Parameter kText[] = {{"text", Type::text}};
constexpr Parameter kIdentity[] = {{"model", Type::text}, {"version", Type::text}};
constexpr Parameter kDeviceState[] = {{"state", Type::u8, device_state_name}};
constexpr Parameter kContamination[] = {{"contamination", Type::u8, contamination_name}};
constexpr Parameter kHours[] = {{"tenths_of_an_hour", Type::u32}};
constexpr Parameter kPowerOns[] = {{"count", Type::u32}};
constexpr Parameter kScanConfig[] = {{"frequency_centihz", Type::u32},
                                     {"areas", Type::u16},
                                     {"resolution_1e4_deg", Type::u32},
                                     {"start_angle_1e4_deg", Type::i32},
                                     {"stop_angle_1e4_deg", Type::i32}};
constexpr Parameter kScanConfigStatus[] = {{"status", Type::u8, scan_config_error}};
constexpr Parameter kOutputRange[] = {{"ranges", Type::u16},
                                      {"resolution_1e4_deg", Type::u32},
                                      {"start_angle_1e4_deg", Type::i32},
                                      {"stop_angle_1e4_deg", Type::i32}};
constexpr Parameter kScanContent[] = {{"channels", Type::bits},  {"rssi", Type::u8},       {"rssi_16_bit", Type::u8},
                                      {"unit", Type::u8},        {"encoders", Type::bits}, {"position", Type::u8},
                                      {"device_name", Type::u8}, {"comment", Type::u8},    {"date", Type::u8},
                                      {"every", Type::u16}};
constexpr Parameter kEchoFilter[] = {{"echo_filter", Type::u8}};
constexpr Parameter kOnOff[] = {{"on", Type::u8}};
constexpr Parameter kSetting[] = {{"setting", Type::u8}};
constexpr Parameter kEncoderResolution[] = {{"mm_per_tick", Type::f32}};
constexpr Parameter kDate[] = {{"year", Type::u16},       {"month", Type::u8},  {"day", Type::u8},
                               {"hour", Type::u8},        {"minute", Type::u8}, {"second", Type::u8},
                               {"microsecond", Type::u32}};
// Only the status of STlms is safe: the listing's example contradicts its own table.
constexpr Parameter kOperatingStatus[] = {{"status", Type::u16, operating_status_name}};

constexpr Layout kLayouts[] = {
    {"sMN SetAccessMode", kLogin},
    {"sAN SetAccessMode", kSuccess},
    {"sRA FirmwareVersion", kText},
    {"sRA LocationName", kText},
    {"sRA DeviceIdent", kIdentity},
    {"sRA SCdevicestate", kDeviceState},
    {"sRA LCMstate", kContamination},
    {"sRA ODoprh", kHours},
    {"sRA ODpwrc", kPowerOns},
    {"sRA STlms", kOperatingStatus},
    {"sMN mLMPsetscancfg", kScanConfig},
    {"sAN mLMPsetscancfg", kScanConfigStatus},
    {"sRA LMPscancfg", kScanConfig},
    {"sWN LMPoutputRange", kOutputRange},
    {"sRA LMPoutputRange", kOutputRange},
    {"sWN LMDscandatacfg", kScanContent},
    {"sRA LMDscandatacfg", kScanContent},
    {"sWN FREchoFilter", kEchoFilter},
    {"sRA FREchoFilter", kEchoFilter},
    {"sWN EIHstCola", kSetting},
    {"sWN LICsrc", kSetting},
    {"sWN LICencset", kSetting},
    {"sWN LICencres", kEncoderResolution},
    {"sWN DO3And4Fnc", kSetting},
    {"sMN LSPsetdatetime", kDate},
    {"sAN LSPsetdatetime", kSuccess},
    {"sAN Run", kSuccess},
    {"sAN mEEwriteall", kSuccess},
    {"sAN LMCstartmeas", kRefusal},
    {"sAN LMCstopmeas", kRefusal},
    {"sEN LMDscandata", kOnOff},
    {"sEA LMDscandata", kOnOff},
};

std::int64_t read_number(ParameterReader& reader, Type type) {
  switch (type) {
    case Type::u8:
      return reader.u8();
    case Type::u16:
      return reader.u16();
    case Type::u32:
      return reader.u32();
    case Type::i32:
      return reader.i32();
    default:
      return reader.bits();
  }
}

void read_parameter(ParameterReader& reader, const Parameter& parameter, Fields& fields) {
  if (parameter.type == Type::text) {
    fields.emplace_back(parameter.name, reader.text(2));
  } else if (parameter.type == Type::f32) {
    fields.emplace_back(parameter.name, static_cast<double>(reader.f32()));
  } else {
    const std::int64_t value = read_number(reader, parameter.type);
    fields.emplace_back(parameter.name, value);
    if (parameter.meaning == nullptr) return;
    fields.emplace_back(std::string(parameter.name) + "_name", parameter.meaning(static_cast<unsigned>(value)));
  }
}

std::string hex_of(std::string_view bytes) {
  constexpr char kDigits[] = "0123456789abcdef";
  std::string text;
  for (const char byte : bytes) {
    text += kDigits[static_cast<std::uint8_t>(byte) >> 4];
    text += kDigits[byte & 0xF];
  }
  return text;
}

}  // namespace

Fields describe(const Telegram& telegram) {
  Fields fields;
  if (telegram.command == "sFA") {
    const unsigned code = error_code(telegram);
    return {{"code", std::int64_t{code}}, {"error", error_name(code)}};
  }
  ParameterReader reader(telegram);
  const std::string key = telegram.command + ' ' + telegram.name;
  for (const Layout& layout : kLayouts) {
    if (layout.telegram != key) continue;
    for (const Parameter& parameter : layout.parameters) read_parameter(reader, parameter, fields);
  }
  if (!reader.at_end()) fields.emplace_back("parameters_hex", hex_of(reader.rest()));
  return fields;
}

unsigned error_code(const Telegram& telegram) { return ParameterReader(telegram).u16(); }

}  // namespace scanway::sick
