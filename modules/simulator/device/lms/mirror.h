#pragma once

#include <cstdint>

#include "common/time/utime.h"
#include "modules/simulator/device/lms/scan_mode.h"

namespace scanway::simulator {

/// A turn of the mirror: its beam i of the sector leaves at `start` + (sector.before + i) * beam_period_us, at the
/// angle sector.start_deg + i step_deg of the device, whose 90 degrees are straight ahead.
struct MirrorTurn {
  std::int64_t number = 0;
  Utime start = 0;  ///< Of the whole field, on the scanner's clock.
  ScanSector sector;
  double step_deg = 0.0;
  double beam_period_us = 0.0;
};

/// The mirror of the scanner, which turns all the time.
class Mirror {
 public:
  const ScanMode& mode() const { return mode_; }
  void set_mode(const ScanMode& mode) { mode_ = mode; }
  std::int32_t sector_start() const { return sector_start_; }
  std::int32_t sector_stop() const { return sector_stop_; }
  /// What of its field is sent, 1/10000 deg.
  void set_sector(std::int32_t start, std::int32_t stop) {
    sector_start_ = start;
    sector_stop_ = stop;
  }

  MirrorTurn turn(std::int64_t number) const;
  Utime start_of(std::int64_t number) const;
  /// When its scan has been put together.
  Utime sent_at(std::int64_t number) const;
  /// The last turn whose scan has been sent, or would have been.
  std::int64_t last_sent_before(Utime now) const;

 private:
  ScanMode mode_;
  std::int32_t sector_start_ = -50000, sector_stop_ = 1850000;
};

}  // namespace scanway::simulator
