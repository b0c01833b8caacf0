#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <set>
#include <span>
#include <vector>

#include "common/delivery/token_bucket.h"

namespace scanway::sick {

struct ArchiveLimits {
  SteadyTime age = 60'000'000;  ///< How long a line is kept.
  std::size_t bytes = std::size_t{64} << 20;
  /// Of lines that are sent again, beside the new ones.
  double bytes_per_second = 500e3;
  double burst_bytes = 20e3;
  /// A line that several ask for goes once within this time.
  SteadyTime pause = 100'000;
};

struct ArchiveCounters {
  std::int64_t lines_resent = 0;
  std::int64_t lines_too_old = 0;  ///< Asked for when they were not kept any more.
  std::int64_t lines_unknown = 0;  ///< Asked for before there were such lines.
};

/// The lines of the last minute, byte for byte as they were published, for whoever missed one.
class LineArchive {
 public:
  using Message = std::vector<std::uint8_t>;

  explicit LineArchive(const ArchiveLimits& limits = {});

  /// Lines are kept in their order: the first is line 0.
  void keep(std::vector<Message> messages, SteadyTime now);
  /// Wants lines from `first` to the one before `end` sent again.
  void ask(std::int64_t first, std::int64_t end, SteadyTime now);
  /// Sends what is asked for, oldest lines first, as fast as the limits permit.
  void pump(SteadyTime now, const std::function<void(const Message&)>& send);

  /// Lines that wait to be sent again.
  std::size_t waiting() const { return wanted_.size(); }
  std::size_t bytes() const { return bytes_; }
  const ArchiveCounters& counters() const { return counters_; }

 private:
  struct Line {
    std::vector<Message> messages;
    SteadyTime kept = 0;
    SteadyTime resent = 0;  ///< 0: never.
  };

  void forget(SteadyTime now);
  Line& line(std::int64_t number) { return lines_[static_cast<std::size_t>(number - first_)]; }
  std::int64_t end() const { return first_ + static_cast<std::int64_t>(lines_.size()); }

  ArchiveLimits limits_;
  TokenBucket bucket_;
  std::deque<Line> lines_;
  std::int64_t first_ = 0;  // Number of lines_.front().
  std::size_t bytes_ = 0;
  std::set<std::int64_t> wanted_;  // All of them kept.
  ArchiveCounters counters_;
};

}  // namespace scanway::sick
