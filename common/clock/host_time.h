#pragma once

#include <chrono>

#include "common/time/utime.h"

namespace scanway {

/// The wall clock of this machine: when a device was heard. Data get their time from the device by way of
/// common/time/device_clock.h wherever it says one.
inline Utime host_now() {
  using namespace std::chrono;
  return duration_cast<microseconds>(system_clock::now().time_since_epoch()).count();
}

}  // namespace scanway
