#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "common/time/utime.h"

namespace scanway {

/// Sees what is missing in a stream of messages that are evenly spaced in time, and have no numbers. Of a stream that
/// is not even (or not yet known to be), nothing is said to be missing.
class Spacing {
 public:
  /// The next message's own time. Returns how many are missing before it.
  std::int64_t add(Utime utime);
  std::int64_t missing() const { return missing_; }  ///< In all.

 private:
  static constexpr std::size_t kRemembered = 32;

  Utime usual() const;  // Interval; 0 if there is none.

  std::array<Utime, kRemembered> intervals_{};  // The last ones, in turns.
  std::size_t known_ = 0;
  Utime last_ = 0;
  bool begun_ = false;
  std::int64_t missing_ = 0;
};

}  // namespace scanway
