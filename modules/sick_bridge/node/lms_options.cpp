#include "modules/sick_bridge/node/lms_options.h"

#include <fmt/format.h>

#include <cmath>
#include <map>

#include "common/files/input_error.h"
#include "modules/sick_bridge/core/scan_geometry.h"

namespace scanway::sick {
namespace {

constexpr double kFirstDeg = -5.0, kLastDeg = 185.0;
constexpr double kUnitsPerDegree = 10000.0;

double degrees(double radians) { return radians * 180.0 / M_PI; }

std::int32_t in_units(double degrees) { return static_cast<std::int32_t>(std::lround(degrees * kUnitsPerDegree)); }

void set_mode(const LmsOptions& options, const Robot::Laser& laser, ScanConfig& scan) {
  const double frequency = options.frequency_hz.value_or(laser.line_rate_hz);
  const double resolution = options.resolution_deg.value_or(degrees(laser.field_of_view) / (laser.beams - 1));
  scan.frequency = static_cast<std::uint32_t>(std::lround(frequency * 100));
  scan.resolution = static_cast<std::uint32_t>(in_units(resolution));
  if (is_mode_of_lms5xx(scan.frequency, scan.resolution)) return;
  throw InputError(
      fmt::format("no LMS5xx scans at {:.4g} Hz with {:.4f} degrees; give --frequency and --resolution, or laser "
                  "line_rate_hz, beams and field_of_view_deg of the robot file, a pair of docs/devices.md",
                  frequency, resolution));
}

void set_sector(const LmsOptions& options, const Robot::Laser& laser, LmsConfig& config) {
  const double half = degrees(laser.field_of_view) / 2;
  const auto whole = std::pair(std::max(kFirstDeg, kAheadDeg - half), std::min(kLastDeg, kAheadDeg + half));
  const auto [first, last] = options.sector_deg.value_or(whole);
  if (!(first >= kFirstDeg && first < last && last <= kLastDeg)) {
    throw InputError(
        fmt::format("--sector {:.4g},{:.4g}: an LMS5xx sees from -5 to 185 degrees, 90 is ahead; give "
                    "the first, then a larger one",
                    first, last));
  }
  config.sector_start = in_units(first);
  config.sector_stop = in_units(last);
}

void set_echo(const std::string& echo, LmsConfig& config) {
  static const std::map<std::string, EchoFilter> kFilters = {
      {"first", EchoFilter::first}, {"last", EchoFilter::last}, {"all", EchoFilter::all}};
  const auto known = kFilters.find(echo);
  if (known == kFilters.end()) throw InputError("--echo " + echo + ": choose first, last or all");
  config.echo = known->second;
  if (config.echo == EchoFilter::all) config.content.channels = 0x1F;
}

}  // namespace

LmsConfig lms_config(const LmsOptions& options, const Robot::Laser& laser) {
  LmsConfig config;
  set_mode(options, laser, config.scan);
  set_sector(options, laser, config);
  set_echo(options.echo, config);
  if (options.rssi_bits != 0 && options.rssi_bits != 8 && options.rssi_bits != 16) {
    throw InputError(fmt::format("--rssi {}: choose 0, 8 or 16 bits", options.rssi_bits));
  }
  config.content.rssi = options.rssi_bits != 0;
  config.content.rssi_16_bit = options.rssi_bits == 16;
  config.store = options.store;
  return config;
}

}  // namespace scanway::sick
