#include "modules/tools/decode/decode_lms.h"

#include <cmath>
#include <iostream>

#include <nlohmann/json.hpp>

#include "common/files/read_file.h"
#include "modules/sick_bridge/core/cola.h"
#include "modules/sick_bridge/core/describe.h"
#include "modules/sick_bridge/core/names.h"
#include "modules/sick_bridge/core/scan.h"
#include "modules/sick_bridge/core/scan_geometry.h"
#include "modules/tools/decode/decode_stream.h"

namespace scanway::tools {
namespace {

using Json = nlohmann::ordered_json;

/// A whole number without a decimal point.
Json number(double value) {
  if (value == std::floor(value) && std::fabs(value) < 1e15) return static_cast<std::int64_t>(value);
  return value;
}

Json ranges_of(const sick::ScanChannel& channel) {
  Json ranges = Json::array();
  for (std::size_t beam = 0; beam < channel.counts.size(); ++beam) {
    const auto range = sick::range_m(channel, beam);
    ranges.push_back(range ? Json(*range) : Json());
  }
  return ranges;
}

Json rssi_of(const sick::ScanChannel* channel) {
  Json values = Json::array();
  if (channel == nullptr) return values;
  for (std::size_t beam = 0; beam < channel->counts.size(); ++beam) values.push_back(number(rssi(*channel, beam)));
  return values;
}

void add_geometry(const sick::Scan& scan, const sick::ScanChannel& channel, Json& line) {
  line["start_angle_deg"] = channel.start_angle / 1e4;
  line["step_deg"] = channel.step / 1e4;
  line["true_step_deg"] = sick::true_step_deg(channel.step);
  const auto period = beam_period_us(scan, channel);
  line["beam_period_us"] = period ? Json(*period) : Json();
  line["scale"] = channel.scale;
  line["offset_mm"] = channel.offset;
}

/// The first echo under the line's own keys, further ones as a list.
void add_echoes(const sick::Scan& scan, Json& line) {
  line["ranges_m"] = Json::array();
  line["rssi"] = Json::array();
  for (int echo = 1; echo <= 5; ++echo) {
    const std::string digit = std::to_string(echo);
    const sick::ScanChannel* ranges = scan.channel("DIST" + digit);
    if (ranges == nullptr) continue;
    Json* place = &line;
    if (echo > 1) place = &line["further_echoes"].emplace_back(Json{{"echo", echo}});
    add_geometry(scan, *ranges, *place);
    (*place)["ranges_m"] = ranges_of(*ranges);
    (*place)["rssi"] = rssi_of(scan.channel("RSSI" + digit));
  }
}

Json date_of(const sick::DeviceDate& date) {
  return {{"year", date.year},
          {"month", date.month},
          {"day", date.day},
          {"hour", date.hour},
          {"minute", date.minute},
          {"second", date.second},
          {"microsecond", date.microsecond}};
}

void add_further_blocks(const sick::Scan& scan, Json& line) {
  line["encoders"] = Json::array();
  for (const auto& encoder : scan.encoders) {
    line["encoders"].push_back({{"position_ticks", encoder.position_ticks}, {"speed", encoder.speed}});
  }
  if (scan.position) {
    line["position"] = {{"position", scan.position->position},
                        {"rotation", scan.position->rotation},
                        {"rotation_type", scan.position->rotation_type}};
  }
  if (scan.device_name) line["device_name"] = *scan.device_name;
  if (scan.comment) line["comment"] = *scan.comment;
  if (scan.date) line["date"] = date_of(*scan.date);
  for (const auto& event : scan.events) {
    line["events"].push_back({{"type", event.type},
                              {"encoder_position", event.encoder_position},
                              {"time_us", event.time_us},
                              {"angle_deg", event.angle / 1e4}});
  }
  if (scan.unread_bytes > 0) line["unread_bytes"] = scan.unread_bytes;
}

Json line_of_scan(const sick::Telegram& telegram) {
  const sick::Scan scan = parse_scan(telegram);
  Json line = {{"type", "LMDscandata"},
               {"dialect", name_of(telegram.dialect)},
               {"command", telegram.command},
               {"scan_counter", scan.scan_counter},
               {"telegram_counter", scan.telegram_counter},
               {"device_time_us", scan.start_time_us},
               {"transmission_time_us", scan.transmission_time_us},
               {"version", scan.version},
               {"device_number", scan.device_number},
               {"serial_number", scan.serial_number},
               {"device_status", scan.device_status},
               {"device_status_name", sick::device_status_text(scan.device_status)},
               {"digital_inputs", scan.digital_inputs},
               {"digital_outputs", scan.digital_outputs},
               {"reserved", scan.reserved},
               {"scan_frequency_hz", number(scan.scan_frequency / 100.0)},
               {"measurement_frequency_hz", std::uint64_t{scan.measurement_frequency} * 100}};
  add_further_blocks(scan, line);
  add_echoes(scan, line);
  return line;
}

Json line_of_telegram(const sick::Telegram& telegram) {
  Json line = {{"type", telegram.command}, {"dialect", name_of(telegram.dialect)}};
  if (!telegram.name.empty()) line["name"] = telegram.name;
  for (const auto& [name, value] : describe(telegram)) {
    std::visit([&](const auto& known) { line[name] = known; }, value);
  }
  return line;
}

Json line_of_frame(std::span<const std::uint8_t> frame) {
  const sick::Telegram telegram = sick::open_frame(frame);
  try {
    return is_scan(telegram) ? line_of_scan(telegram) : line_of_telegram(telegram);
  } catch (const sick::BadTelegram& error) {
    throw sick::BadTelegram(telegram.command + ' ' + telegram.name + ": " + error.what());
  }
}

}  // namespace

void decode_lms(std::span<const std::uint8_t> bytes, std::ostream& out) {
  FrameFinder finder = sick::make_frame_finder();
  decode_stream(finder, bytes, out, line_of_frame);
}

int run_decode_lms(const std::string& file) {
  const std::string bytes = read_file(file);
  decode_lms(std::span(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()), std::cout);
  return 0;
}

}  // namespace scanway::tools
