#pragma once

#include <algorithm>

#include "common/clock/steady_time.h"

namespace scanway {

/// Lets through so many bytes a second, and after a pause a burst of so many at once.
class TokenBucket {
 public:
  TokenBucket(double bytes_per_second, double burst_bytes)
      : bytes_per_us_(bytes_per_second / 1e6), burst_(burst_bytes), tokens_(burst_bytes) {}

  void refill(SteadyTime now) {
    if (last_ != 0) tokens_ = std::min(burst_, tokens_ + static_cast<double>(now - last_) * bytes_per_us_);
    last_ = now;
  }
  /// Whether something may go now; what is larger than what is left is paid for later.
  bool take(double bytes) {
    if (tokens_ <= 0) return false;
    tokens_ -= bytes;
    return true;
  }

 private:
  double bytes_per_us_;
  double burst_;
  double tokens_;
  SteadyTime last_ = 0;
};

}  // namespace scanway
