#pragma once

#include <algorithm>

#include "common/time/utime.h"

namespace scanway::sick {

/// When to try again: soon at first, then less and less often.
class BackOff {
 public:
  static constexpr Utime kFirst = kMicrosecondsPerSecond / 2;
  static constexpr Utime kLongest = 8 * kMicrosecondsPerSecond;

  bool due(Utime now) const { return now >= next_; }
  /// After an attempt that failed.
  void failed(Utime now) {
    next_ = now + wait_;
    wait_ = std::min(2 * wait_, kLongest);
  }
  /// After an attempt that did not.
  void succeeded() { wait_ = kFirst; }

 private:
  Utime next_ = 0;
  Utime wait_ = kFirst;
};

}  // namespace scanway::sick
