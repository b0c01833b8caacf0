#include "modules/sick_bridge/core/scan_geometry.h"

#include <cmath>

namespace scanway::sick {
namespace {

constexpr double kUnitsPerDegree = 10000.0;
constexpr double kMetresPerMillimetre = 1000.0;

constexpr ScanMode kModes[] = {
    {2500, 1667, false}, {2500, 2500, false}, {3500, 2500, false},  {3500, 5000, false},  {5000, 3333, false},
    {5000, 5000, false}, {7500, 5000, false}, {7500, 10000, false}, {10000, 6667, false}, {10000, 10000, false},
    {5000, 1667, true},  {7500, 2500, true},  {10000, 1667, true},  {10000, 3333, true},  {10000, 5000, true},
    {2500, 833, true},   {2500, 417, true},
};

double value_of(const ScanChannel& channel, std::size_t beam) {
  return channel.counts[beam] * static_cast<double>(channel.scale) + static_cast<double>(channel.offset);
}

}  // namespace

std::optional<double> range_m(const ScanChannel& channel, std::size_t beam) {
  if (channel.counts[beam] < kFirstRangeCount) return std::nullopt;
  return value_of(channel, beam) / kMetresPerMillimetre;
}

double rssi(const ScanChannel& channel, std::size_t beam) { return value_of(channel, beam); }

double true_step_deg(std::uint16_t step) {
  const double given = step / kUnitsPerDegree;
  if (step == 0 || given > 1.0) return given;
  return 2.0 / std::floor(2.0 / given + 0.5);
}

double beam_angle_deg(const ScanChannel& channel, std::size_t beam) {
  return channel.start_angle / kUnitsPerDegree + static_cast<double>(beam) * true_step_deg(channel.step);
}

std::optional<double> beam_period_us(const Scan& scan, const ScanChannel& channel) {
  if (scan.scan_frequency == 0) return std::nullopt;
  const double revolution_us = 1e8 / scan.scan_frequency;
  return true_step_deg(channel.step) / 360.0 * revolution_us;
}

std::optional<ScanMode> find_mode(std::uint32_t frequency, std::uint32_t resolution) {
  for (const ScanMode& mode : kModes) {
    if (mode.frequency == frequency && mode.resolution == resolution) return mode;
  }
  return std::nullopt;
}

bool is_mode_of_lms5xx(std::uint32_t frequency, std::uint32_t resolution) {
  return find_mode(frequency, resolution).has_value();
}

}  // namespace scanway::sick
