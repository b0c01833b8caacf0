#pragma once

#include <cstdint>

namespace scanway::simulator {

/// How the mirror turns and how often the laser fires.
struct ScanMode {
  std::uint32_t frequency = 2500;     ///< 1/100 Hz.
  std::uint32_t resolution = 1667;    ///< 1/10000 deg.
  std::int32_t start_angle = -50000;  ///< 1/10000 deg.
  std::int32_t stop_angle = 1850000;

  double period_us() const { return 1e8 / frequency; }
  /// Degrees between two beams. The code is rounded: 1667 is a sixth of a degree.
  double step_deg() const;
  /// 100 Hz.
  std::uint32_t measurement_frequency() const;
};

/// The code by which an LMS5xx answers to this mode: 0 ok, 1 frequency, 2 resolution, 4 area. Interlaced modes are
/// not simulated.
unsigned scan_mode_error(const ScanMode& mode);

/// The beams of a sector: beam i is at start_angle + i step.
struct ScanSector {
  double start_deg = -5.0;  ///< As it is written, in 1/10000 deg; beam `first` of the whole field.
  int first = 0;
  int beams = 1141;
};

/// The beams of `mode` from `start` to `stop`, 1/10000 deg.
ScanSector sector_of(const ScanMode& mode, std::int32_t start, std::int32_t stop);

}  // namespace scanway::simulator
