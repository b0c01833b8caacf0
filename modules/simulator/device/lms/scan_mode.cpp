#include "modules/simulator/device/lms/scan_mode.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace scanway::simulator {
namespace {

constexpr double kStart_deg = -5.0, kStop_deg = 185.0;

struct KnownMode {
  std::uint32_t frequency, resolution;
  int interlacing = 1;
};
// SICK telegram listing, variant table of the LMS500.
constexpr std::array<KnownMode, 17> kModes = {{{2500, 1667},
                                               {2500, 2500},
                                               {3500, 2500},
                                               {3500, 5000},
                                               {5000, 3333},
                                               {5000, 5000},
                                               {7500, 5000},
                                               {7500, 10000},
                                               {10000, 6667},
                                               {10000, 10000},
                                               {2500, 833, 2},
                                               {2500, 417, 4},
                                               {5000, 1667, 2},
                                               {7500, 2500, 2},
                                               {10000, 1667, 4},
                                               {10000, 3333, 2},
                                               {10000, 5000, 2}}};

/// In which order the turns have the beams, in steps of the resolution. As recorded with four turns.
int shift_of(int interlacing, std::int64_t turn) {
  constexpr std::array<int, 4> kOfFour = {0, 2, 1, 3};
  return interlacing == 4 ? kOfFour[static_cast<std::size_t>(turn % 4)] : static_cast<int>(turn % interlacing);
}

double true_step_deg(std::uint32_t code) {
  const double written = code * 1e-4;
  return 2.0 / std::round(2.0 / written);
}

}  // namespace

int ScanMode::interlacing() const {
  const auto known = std::find_if(kModes.begin(), kModes.end(), [&](const KnownMode& one) {
    return one.frequency == frequency && one.resolution == resolution;
  });
  return known == kModes.end() ? 1 : known->interlacing;
}

double ScanMode::step_deg() const { return true_step_deg(resolution) * interlacing(); }

std::uint32_t ScanMode::measurement_frequency() const {
  return static_cast<std::uint32_t>(std::lround(frequency / 100.0 * 360.0 / step_deg() / 100.0));
}

unsigned scan_mode_error(const ScanMode& mode) {
  const auto count = [&](const auto& fits) { return std::count_if(kModes.begin(), kModes.end(), fits); };
  if (count([&](const KnownMode& known) { return known.frequency == mode.frequency; }) == 0) return 1;
  if (count([&](const KnownMode& known) {
        return known.frequency == mode.frequency && known.resolution == mode.resolution;
      }) == 0) {
    return 2;
  }
  return mode.start_angle == -50000 && mode.stop_angle == 1850000 ? 0 : 4;
}

ScanSector sector_of(const ScanMode& mode, std::int32_t start, std::int32_t stop, std::int64_t turn) {
  constexpr double kRounding = 0.01;  // Of a step.
  const double step = mode.step_deg();
  const int shift = shift_of(mode.interlacing(), turn);
  const double shifted = static_cast<double>(shift) / mode.interlacing();
  const auto beam_at = [&](double degrees) {
    return (std::clamp(degrees, kStart_deg, kStop_deg) - kStart_deg) / step - shifted;
  };
  const int first = static_cast<int>(std::ceil(beam_at(start * 1e-4) - kRounding));
  const int last = static_cast<int>(std::floor(beam_at(stop * 1e-4) + kRounding));
  const auto written = static_cast<std::int32_t>(std::lround((kStart_deg + first * step) * 1e4)) +
                       shift * static_cast<std::int32_t>(mode.resolution);
  return {kStart_deg + (first + shifted) * step, written, first + shifted, std::max(0, last - first + 1)};
}

}  // namespace scanway::simulator
