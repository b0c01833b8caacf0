#include "modules/simulator/device/lms/scan_mode.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace scanway::simulator {
namespace {

constexpr double kStart_deg = -5.0, kStop_deg = 185.0;

struct Pairing {
  std::uint32_t frequency;
  std::array<std::uint32_t, 2> resolutions;
};
// SICK telegram listing, variant table; LMS500 without interlacing.
constexpr std::array<Pairing, 5> kModes = {
    {{2500, {1667, 2500}}, {3500, {2500, 5000}}, {5000, {3333, 5000}}, {7500, {5000, 10000}}, {10000, {6667, 10000}}}};

}  // namespace

double ScanMode::step_deg() const {
  const double written = resolution * 1e-4;
  return 2.0 / std::round(2.0 / written);
}

std::uint32_t ScanMode::measurement_frequency() const {
  return static_cast<std::uint32_t>(std::lround(frequency / 100.0 * 360.0 / step_deg() / 100.0));
}

unsigned scan_mode_error(const ScanMode& mode) {
  const auto pairing = std::find_if(kModes.begin(), kModes.end(),
                                    [&](const Pairing& known) { return known.frequency == mode.frequency; });
  if (pairing == kModes.end()) return 1;
  if (std::find(pairing->resolutions.begin(), pairing->resolutions.end(), mode.resolution) ==
      pairing->resolutions.end()) {
    return 2;
  }
  return mode.start_angle == -50000 && mode.stop_angle == 1850000 ? 0 : 4;
}

ScanSector sector_of(const ScanMode& mode, std::int32_t start, std::int32_t stop) {
  constexpr double kRounding = 0.01;  // Of a step.
  const double step = mode.step_deg();
  const auto beam_at = [&](double degrees) { return (std::clamp(degrees, kStart_deg, kStop_deg) - kStart_deg) / step; };
  const int first = static_cast<int>(std::ceil(beam_at(start * 1e-4) - kRounding));
  const int last = static_cast<int>(std::floor(beam_at(stop * 1e-4) + kRounding));
  return {kStart_deg + first * step, first, std::max(0, last - first + 1)};
}

}  // namespace scanway::simulator
