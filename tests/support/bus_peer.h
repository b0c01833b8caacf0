#pragma once

#include <chrono>
#include <map>
#include <string>
#include <vector>

#include "common/bus/channels.h"
#include "common/bus/lcm_bus.h"
#include "common/clock/host_time.h"
#include "common/clock/steady_time.h"
#include "common/messages/codec.h"
#include "scanway/health_t.hpp"

namespace scanway::test {

/// Who talks with a program over LCM: on the private network's bus.
class BusPeer {
 public:
  BusPeer() : bus_("udpm://239.255.76.67:7667?ttl=0") {
    bus_.subscribe(channel::kHealth.name, [this](const BusMessage& message) {
      const auto health = decode<health_t>(message.bytes);
      health_[health.process_name] = health;
    });
  }

  /// Keeps what comes on `channel` in `heard`.
  template <class T>
  void keep(const Channel& channel, std::vector<T>& heard) {
    bus_.subscribe(channel.name, [&heard](const BusMessage& message) { heard.push_back(decode<T>(message.bytes)); });
  }
  template <class T>
  void say(const Channel& channel, const T& message) {
    bus_.publish(channel.name, encode(message), 0);
  }
  /// Listens until `done`; false: not within the time.
  template <class Done>
  bool listen_until(const Done& done, double limit_s = 20) {
    for (const SteadyTime end = steady_now() + static_cast<SteadyTime>(limit_s * 1e6); steady_now() < end;) {
      bus_.dispatch(std::chrono::milliseconds(2));
      if (done()) return true;
    }
    return false;
  }

  std::string summary(const std::string& process) const {
    const auto health = health_.find(process);
    return health == health_.end() ? "(no HEALTH of " + process + ")" : health->second.summary;
  }
  std::int64_t counter(const std::string& process, const std::string& name) const {
    const auto health = health_.find(process);
    if (health == health_.end()) return -1;
    for (const counter_t& counter : health->second.counters) {
      if (counter.counter_name == name) return counter.count;
    }
    return -1;
  }

 private:
  LcmBus bus_;
  std::map<std::string, health_t> health_;
};

}  // namespace scanway::test
