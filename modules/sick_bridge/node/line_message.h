#pragma once

#include <cstdint>
#include <vector>

#include "bot_core/planar_lidar_t.hpp"
#include "common/time/utime.h"
#include "modules/sick_bridge/core/scan.h"
#include "scanway/laser_line_t.hpp"

namespace scanway::sick {

/// Which line a scan becomes.
struct LineNumber {
  std::int64_t line = 0;
  Utime numbered_since = 0;
  Utime utime = 0;  ///< When its first beam was measured.
};

/// LASER_LINE: all echoes of a scan with their remission, in pieces of at most kMaxLineBytes, as the device counts
/// ranges, remission and angles (0 to its right). Empty when the scan has no ranges, or does not say how fast the
/// mirror turns.
std::vector<laser_line_t> line_messages(const Scan& scan, const LineNumber& number);

constexpr std::size_t kMaxLineBytes = 1300;

/// LASER_SCAN: the first echo in metres, kNoReturn where nothing came back; angles in `laser` (0 straight ahead).
bot_core::planar_lidar_t lidar_message(const Scan& scan, Utime utime);

constexpr float kNoReturn = -1.0F;

}  // namespace scanway::sick
