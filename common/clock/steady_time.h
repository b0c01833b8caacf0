#pragma once

#include <chrono>
#include <cstdint>

namespace scanway {

/// Microseconds of a clock that only runs forward: for waiting and pacing, never for data.
using SteadyTime = std::int64_t;

inline constexpr SteadyTime kSteadySecond = 1'000'000;

inline SteadyTime steady_now() {
  using namespace std::chrono;
  return duration_cast<microseconds>(steady_clock::now().time_since_epoch()).count();
}

}  // namespace scanway
