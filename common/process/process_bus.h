#pragma once

#include <string>

#include "common/bus/lcm_bus.h"
#include "common/delivery/live_bus.h"

namespace scanway {

/// The bus of a program: LCM, with the delivery of objects on it. What this machine should set better for LCM is said
/// in the program's log.
class ProcessBus {
 public:
  /// `url` empty: LCM_DEFAULT_URL, or LCM's default. Throws InputError as LcmBus does.
  ProcessBus(const std::string& url, const Identity& who, const LiveBusOptions& options = {});

  LiveBus& live() { return live_; }

  /// Takes part from now on. Throws InputError if an elder process of the same name is there.
  void start();

 private:
  LcmBus lcm_;
  LiveBus live_;
};

}  // namespace scanway
