#pragma once

#include <cstdint>

namespace scanway {

/// Microseconds since 1970-01-01 UTC: when something was measured, never when it was sent or processed.
using Utime = std::int64_t;

constexpr Utime kMicrosecondsPerSecond = 1'000'000;

constexpr double to_seconds(Utime duration) { return static_cast<double>(duration) / kMicrosecondsPerSecond; }

}  // namespace scanway
