#pragma once

#include <cstdint>

namespace scanway::simulator {

/// How the mirror turns and how often the laser fires. In an interlaced mode a turn has every second or fourth beam of
/// the resolution, and the turns that follow have the others.
struct ScanMode {
  std::uint32_t frequency = 2500;     ///< Of the mirror, 1/100 Hz.
  std::uint32_t resolution = 1667;    ///< 1/10000 deg.
  std::int32_t start_angle = -50000;  ///< 1/10000 deg.
  std::int32_t stop_angle = 1850000;

  double period_us() const { return 1e8 / frequency; }
  /// Turns that make up the resolution: 1, 2 or 4.
  int interlacing() const;
  /// Degrees between two beams of a turn. The code is rounded: 1667 is a sixth of a degree.
  double step_deg() const;
  /// 100 Hz.
  std::uint32_t measurement_frequency() const;
};

/// The code by which an LMS5xx answers to this mode: 0 ok, 1 frequency, 2 resolution, 4 area.
unsigned scan_mode_error(const ScanMode& mode);

/// The beams of a sector in one turn.
struct ScanSector {
  double start_deg = -5.0;              ///< Of its first beam,
  std::int32_t written_start = -50000;  ///< and as the scanner writes it, 1/10000 deg.
  double before = 0.0;                  ///< Beams from the whole field's start to it; a part of one where interlaced.
  int beams = 1141;
};

/// The beams of that turn in `mode` from `start` to `stop`, 1/10000 deg.
ScanSector sector_of(const ScanMode& mode, std::int32_t start, std::int32_t stop, std::int64_t turn);

}  // namespace scanway::simulator
