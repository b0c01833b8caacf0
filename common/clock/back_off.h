#pragma once

#include <algorithm>
#include <string>

#include "common/clock/steady_time.h"

namespace scanway {

/// When to try again what failed: soon at first, then less and less often; and whether its reason is news.
class BackOff {
 public:
  /// Pauses of `first` microseconds up to `longest`, each twice the one before it.
  BackOff(SteadyTime first, SteadyTime longest) : first_(first), longest_(longest), pause_(first) {}

  bool due(SteadyTime now) const { return now >= next_; }
  /// After an attempt that failed. Returns whether it failed for another reason than the one before it.
  bool failed(const std::string& reason, SteadyTime now) {
    next_ = now + pause_;
    pause_ = std::min(2 * pause_, longest_);
    const bool is_news = reason != reason_;
    reason_ = reason;
    return is_news;
  }
  /// After an attempt that did not.
  void succeeded() {
    pause_ = first_;
    reason_.clear();
  }
  /// Why the last attempt failed; empty after one that did not, and before the first.
  const std::string& reason() const { return reason_; }

 private:
  SteadyTime first_, longest_, pause_;
  SteadyTime next_ = 0;
  std::string reason_;
};

}  // namespace scanway
