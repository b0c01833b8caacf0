#pragma once

#include <cstdint>
#include <optional>

#include "common/time/utime.h"

namespace scanway {

/// How a device counts time.
struct DeviceClockModel {
  std::int64_t tick_us = 1;
  std::int64_t wrap_ticks = std::int64_t{1} << 32;  ///< The counter goes from wrap_ticks - 1 to 0.

  bool operator==(const DeviceClockModel&) const = default;
};

/// Maps a device's clock to the host's, live, from pairs of a device time and the host time at which it was heard of.
///
/// A message can be late but never early, so the smallest difference of host and device time is the nearest to the
/// truth: the clock takes the smallest over the last window (10 to 20 s), which follows the drift of both clocks and
/// forgets a host clock that was set. Passive synchronisation as in E. Olson, A Passive Solution to the Sensor
/// Synchronization Problem, IROS 2010, with a window in place of a bound on the drift.
///
/// A counter that wraps (after 71 min for 32 bits of microseconds) is followed by the host time that went by, however
/// long the device was silent. A device time far from every expectation means that the device or the host clock was
/// set anew: the clock starts again and counts a jump.
class DeviceClock {
 public:
  explicit DeviceClock(const DeviceClockModel& model = {}) : model_(model) {}

  /// A device time that was heard of at `arrival`.
  void observe(std::int64_t ticks, Utime arrival);
  /// The host time of a device time that is nearer than half a wrap to the last one observed. Nothing before that.
  std::optional<Utime> to_host(std::int64_t ticks) const;
  /// Forgets everything but the counter of jumps: for a device that was connected anew.
  void restart();

  std::int64_t jumps() const { return jumps_; }

  static constexpr Utime kWindow = 10 * kMicrosecondsPerSecond;
  static constexpr Utime kJump = 5 * kMicrosecondsPerSecond;

 private:
  /// Microseconds of device time, counted on over wraps, of a time near `device_us`.
  Utime unwrap(std::int64_t ticks, Utime near_device_us) const;
  void begin(std::int64_t ticks, Utime arrival);

  DeviceClockModel model_;
  bool running_ = false;
  Utime last_device_us_ = 0;  // Counted on over wraps.
  Utime last_arrival_ = 0;
  Utime window_start_ = 0;     // In device time.
  Utime smallest_ = 0;         // Host minus device time in this window,
  Utime smallest_before_ = 0;  // and in the one before it.
  std::int64_t jumps_ = 0;
};

}  // namespace scanway
