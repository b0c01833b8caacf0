#include "common/time/device_clock.h"

#include <algorithm>
#include <cstdlib>

namespace scanway {
namespace {

/// `value` divided by `divisor`, to the nearest.
std::int64_t divide_rounded(std::int64_t value, std::int64_t divisor) {
  const std::int64_t half = divisor / 2;
  return (value >= 0 ? value + half : value - half) / divisor;
}

}  // namespace

void DeviceClock::observe(std::int64_t ticks, Utime arrival) {
  if (!running_) return begin(ticks, arrival);
  const Utime device_us = unwrap(ticks, last_device_us_ + (arrival - last_arrival_));
  const Utime difference = arrival - device_us;
  if (std::abs(difference - std::min(smallest_, smallest_before_)) > kJump) {
    ++jumps_;
    return begin(ticks, arrival);
  }
  if (device_us - window_start_ > kWindow) {
    // A window without observations has nothing to say: after a silence, only what comes now counts.
    const bool silent = device_us - window_start_ > 2 * kWindow;
    smallest_before_ = silent ? difference : smallest_;
    smallest_ = difference;
    window_start_ = device_us;
  }
  smallest_ = std::min(smallest_, difference);
  last_device_us_ = device_us;
  last_arrival_ = arrival;
}

std::optional<Utime> DeviceClock::to_host(std::int64_t ticks) const {
  if (!running_) return std::nullopt;
  return unwrap(ticks, last_device_us_) + std::min(smallest_, smallest_before_);
}

void DeviceClock::restart() { running_ = false; }

Utime DeviceClock::unwrap(std::int64_t ticks, Utime near_device_us) const {
  const Utime wrap_us = model_.wrap_ticks * model_.tick_us;
  const Utime device_us = ticks * model_.tick_us;
  return device_us + divide_rounded(near_device_us - device_us, wrap_us) * wrap_us;
}

void DeviceClock::begin(std::int64_t ticks, Utime arrival) {
  running_ = true;
  last_device_us_ = ticks * model_.tick_us;
  last_arrival_ = arrival;
  window_start_ = last_device_us_;
  smallest_ = smallest_before_ = arrival - last_device_us_;
}

}  // namespace scanway
