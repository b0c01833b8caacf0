#pragma once

#include <vector>

#include "bot_core/ins_t.hpp"
#include "bot_core/joint_state_t.hpp"
#include "modules/simulator/core/laser/raw_sweep.h"
#include "modules/simulator/core/tracker.h"
#include "scanway/laser_line_t.hpp"
#include "scanway/sweep_mark_t.hpp"

/// What the device bridges would say of a simulated sweep.
namespace scanway::simulator {

/// A sweep's place among others of one log.
struct SweepNumbers {
  std::int64_t sweep = 1;
  std::int64_t first_line = 0;
  Utime numbered_since = 0;
};

/// The pieces of one line (row of `raw`), each at most 1,300 bytes long.
std::vector<laser_line_t> line_messages(const RawSweep& raw, int row, const SweepNumbers& numbers);
sweep_mark_t mark_message(const ScanPattern& pattern, std::int8_t mark, const SweepNumbers& numbers);
bot_core::joint_state_t joint_message(const ScanPattern& pattern, Utime utime);
/// `number`: of the reading, by the tracker's counter.
bot_core::ins_t tracker_message(const TrackerReading& reading, std::int64_t number, Utime utime);

}  // namespace scanway::simulator
