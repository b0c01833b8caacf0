#include "modules/sick_bridge/core/start_up.h"

#include "modules/sick_bridge/core/names.h"
#include "modules/sick_bridge/core/parameters.h"
#include "modules/sick_bridge/core/scan_geometry.h"

namespace scanway::sick {
namespace {

constexpr Utime kReadPatience = 2 * kMicrosecondsPerSecond;
constexpr Utime kWritePatience = 5 * kMicrosecondsPerSecond;

using Accept = std::function<std::string(const Telegram&, DeviceInfo&)>;

Step read_step(Dialect dialect, const char* name, const Accept& accept) {
  return {.purpose = "tell " + std::string(name),
          .request = read_variable(dialect, name),
          .patience = kReadPatience,
          .is_question = true,
          .accept = accept,
          .needed = {}};
}

Step change_step(const char* purpose, Request request, const Accept& accept = {}) {
  return {
      .purpose = purpose, .request = std::move(request), .patience = kWritePatience, .accept = accept, .needed = {}};
}

/// For methods that answer with this number when they did as they were told.
Accept expect(unsigned success) {
  return [success](const Telegram& answer, DeviceInfo&) {
    const unsigned value = ParameterReader(answer).u8();
    return value == success ? std::string() : "it answers " + std::to_string(value);
  };
}

template <class Value>
Accept note_number(std::optional<Value> DeviceInfo::*place, int size) {
  return [place, size](const Telegram& answer, DeviceInfo& info) {
    ParameterReader reader(answer);
    info.*place = size == 1 ? reader.u8() : size == 2 ? reader.u16() : reader.u32();
    return std::string();
  };
}

Accept note_text(std::string DeviceInfo::*place) {
  return [place](const Telegram& answer, DeviceInfo& info) {
    std::string text = ParameterReader(answer).text(2);
    text.erase(text.find_last_not_of(' ') + 1);
    info.*place = text;
    return std::string();
  };
}

std::string note_scan_config(const Telegram& answer, DeviceInfo& info) {
  ParameterReader reader(answer);
  ScanConfig config;
  config.frequency = reader.u32();
  reader.u16();  // Number of scan areas.
  config.resolution = reader.u32();
  config.start_angle = reader.i32();
  config.stop_angle = reader.i32();
  info.scan = config;
  return {};
}

std::string accept_subscription(const Telegram& answer, DeviceInfo&) {
  return ParameterReader(answer).u8() == 1 ? std::string() : "it answers that it is off";
}

std::string accept_scan_config(const Telegram& answer, DeviceInfo&) {
  const std::string trouble = scan_config_error(ParameterReader(answer).u8());
  return trouble.empty() ? trouble : "it does not accept the " + trouble;
}

void add_questions(Dialect dialect, std::vector<Step>& steps) {
  steps.push_back(read_step(dialect, "DeviceIdent", note_text(&DeviceInfo::model)));
  steps.push_back(read_step(dialect, "FirmwareVersion", note_text(&DeviceInfo::firmware)));
  steps.push_back(read_step(dialect, "LocationName", note_text(&DeviceInfo::location_name)));
  steps.push_back(read_step(dialect, "ODoprh", [](const Telegram& answer, DeviceInfo& info) {
    info.operating_hours = ParameterReader(answer).u32() / 10.0;
    return std::string();
  }));
  steps.push_back(read_step(dialect, "ODpwrc", note_number(&DeviceInfo::power_on_count, 4)));
  for (Step& step : status_steps(dialect)) steps.push_back(std::move(step));
  steps.push_back(read_step(dialect, "STlms", note_number(&DeviceInfo::operating_status, 2)));
  steps.push_back(read_step(dialect, "LMPscancfg", note_scan_config));
}

void add_settings(const LmsConfig& config, Dialect dialect, std::vector<Step>& steps) {
  steps.push_back(change_step("accept the login", log_in(dialect), expect(1)));
  Step mode = change_step("take the scan mode", set_scan_config(dialect, config.scan), accept_scan_config);
  mode.slows_down = true;
  mode.patience = 10 * kMicrosecondsPerSecond;
  // Changing it costs up to half a minute without scans, so it is left alone where it is right.
  mode.needed = [wanted = config.scan](const DeviceInfo& info) { return info.scan != wanted; };
  steps.push_back(mode);
  steps.push_back(change_step("take the echo filter", set_echo_filter(dialect, config.echo)));
  steps.push_back(change_step("take the content of its telegrams", set_scan_content(dialect, config.content)));
  ScanConfig sector = config.scan;
  sector.start_angle = config.sector_start;
  sector.stop_angle = config.sector_stop;
  steps.push_back(change_step("take the sector", set_output_range(dialect, sector)));
  if (config.store) {
    steps.push_back(change_step("store its settings", call_method(dialect, "mEEwriteall"), expect(1)));
  }
}

}  // namespace

std::vector<Step> start_up_steps(const LmsConfig& config, Dialect dialect) {
  std::vector<Step> steps;
  add_questions(dialect, steps);
  add_settings(config, dialect, steps);
  steps.push_back(change_step("start measuring", call_method(dialect, "LMCstartmeas"), expect(0)));
  steps.push_back(change_step("run", call_method(dialect, "Run"), expect(1)));
  steps.push_back(change_step("send scans", subscribe(dialect, "LMDscandata", true), accept_subscription));
  steps.back().required = true;
  return steps;
}

std::vector<Step> status_steps(Dialect dialect) {
  return {read_step(dialect, "SCdevicestate", note_number(&DeviceInfo::device_state, 1)),
          read_step(dialect, "LCMstate", note_number(&DeviceInfo::contamination, 1))};
}

}  // namespace scanway::sick
