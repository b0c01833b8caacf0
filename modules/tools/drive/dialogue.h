#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "common/bus/channels.h"
#include "common/bus/lcm_bus.h"
#include "common/clock/steady_time.h"
#include "common/messages/bad_message.h"
#include "common/messages/codec.h"

namespace scanway::tools {

/// With whom one talks, and for how long at most it is silent while it runs.
struct Partner {
  std::string program;
  SteadyTime longest_silence = 0;
};

/// A talk with one process over a bus on which any message may be lost: what is said is said again until it is
/// answered.
class Dialogue {
 public:
  /// `lcm_url`: empty: LCM_DEFAULT_URL, or LCM's default.
  Dialogue(const std::string& lcm_url, Partner partner);

  /// What comes on the channel from now on. What is of another version, or no message at all, is as if it had not come.
  template <class T>
  void hear(const Channel& channel, const std::function<void(const T&)>& take) {
    bus_.subscribe(channel.name, [take](const BusMessage& message) {
      try {
        take(decode<T>(message.bytes));
      } catch (const BadMessage&) {
      }
    });
  }
  /// To be called for what only the partner says.
  void note_partner() { heard_ = steady_now(); }

  /// Waits a moment for what comes. Throws InputError when the partner is silent for too long.
  void listen();
  /// Says it at once, and again every `period` until it is answered.
  void say_until(const std::function<bool()>& answered, SteadyTime period, const Channel& channel,
                 const std::vector<std::uint8_t>& message);

 private:
  LcmBus bus_;
  Partner partner_;
  SteadyTime heard_ = steady_now();
};

}  // namespace scanway::tools
