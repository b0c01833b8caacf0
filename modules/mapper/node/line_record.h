#pragma once

#include <cstdint>
#include <map>
#include <optional>

#include "modules/mapper/core/assembly/line_collector.h"
#include "modules/mapper/node/line_asker.h"
#include "scanway/laser_line_t.hpp"

namespace scanway {

/// When the pan began to turn, and ended.
struct SweepTime {
  Utime started = 0;
  std::optional<Utime> ended;  ///< Absent while it turns.
};

/// Which lines came and when they were measured, and so which lack, whole or in part.
class LineRecord {
 public:
  /// Longer than a line lasts at the least: at 25 Hz the mirror turns in 40 ms.
  static constexpr Utime kLongestLine = 50'000;

  /// Throws BadMessage for a piece that is not of its line.
  void add(const laser_line_t& line);
  /// What no sweep will be made of any more.
  void forget_before(Utime utime);

  /// Of the sweep, as far as it has come. `newest`: of all data, by which lines may still be in flight; `silent`: none
  /// is, for nothing comes any more.
  LineStretches missing(const SweepTime& sweep, Utime newest, bool silent) const;
  /// Whether a line that was measured until then or later has come.
  bool reaches(Utime utime) const { return !times_.empty() && times_.rbegin()->second.end >= utime; }
  /// Of the line that the pan ends in, some pieces may still be in flight, which nobody misses yet.
  bool last_is_whole(Utime ended) const;

  std::int64_t numbered_since() const { return numbered_since_; }
  std::optional<std::int64_t> first() const {
    return times_.empty() ? std::nullopt : std::optional(times_.begin()->first);
  }
  std::size_t repeated_pieces() const { return collector_.repeated_pieces(); }

 private:
  LineStretches missing_at_edges(const SweepTime& sweep, Utime newest) const;

  struct LineTime {
    Utime begin = 0, end = 0;
  };
  LineCollector collector_;                 // What of them is whole.
  std::map<std::int64_t, LineTime> times_;  // By number; also of those that are not whole.
  std::int64_t numbered_since_ = 0;
};

}  // namespace scanway
