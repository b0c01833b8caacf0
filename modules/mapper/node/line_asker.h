#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "common/time/utime.h"
#include "scanway/line_request_t.hpp"

namespace scanway {

/// Stretches of lines, from the first number to the last.
using LineStretches = std::vector<std::pair<std::int64_t, std::int64_t>>;

/// Says when to ask for which of the lines that did not come: at once, then ever less often, and not for ever.
class LineAsker {
 public:
  /// What to ask for at the data time `now`, of those that are missing; nothing if it is too early for all of them.
  std::optional<line_request_t> ask(const LineStretches& missing, std::int64_t numbered_since, Utime now);
  /// As much time has passed as it takes: silence has no data time.
  void hurry();
  /// Lines before that one are no longer wanted.
  void forget_before(std::int64_t line) { asked_.erase(asked_.begin(), asked_.lower_bound(line)); }

  std::int64_t requests() const { return requests_; }
  std::int64_t lines_asked() const { return lines_asked_; }

 private:
  struct Asked {
    int times = 0;
    Utime next = 0;
  };

  bool is_due(std::int64_t line, Utime now) const;

  std::int64_t numbered_since_ = 0;
  std::map<std::int64_t, Asked> asked_;  // By line.
  std::int64_t requests_ = 0, lines_asked_ = 0;
};

}  // namespace scanway
