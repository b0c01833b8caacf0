#pragma once

#include <cstdint>
#include <vector>

#include "modules/simulator/device/lms/mirror.h"
#include "modules/simulator/device/lms/scan_telegram.h"
#include "modules/simulator/device/lms/telegram.h"

namespace scanway::simulator {

/// What the scanner sees in one turn of its mirror.
struct ScannedLine {
  double scale = 1.0;                 ///< Millimetres of a count.
  std::vector<std::uint16_t> ranges;  ///< One a beam of the sector; below 16: none.
  std::vector<std::uint8_t> remissions;
};

/// What the host wants its scans to hold (LMDscandatacfg).
struct ScanContent {
  unsigned channels = 1;
  unsigned remission = 1, remission_resolution = 0, unit = 0;
  unsigned encoders = 0;
  unsigned position = 0, name = 0, comment = 0, time = 1;
  unsigned every = 1;

  static ScanContent read(HostValues& values);
  void write(TelegramWriter& telegram) const;
};

/// Puts the line into the scan, with so many echoes a beam: there is one, the others are empty.
void add_channels(ScanTelegram& scan, const ScannedLine& line, const MirrorTurn& turn, int echoes, bool remission);

}  // namespace scanway::simulator
