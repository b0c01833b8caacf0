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
      summaries_[health.process_name] = health.summary;
      for (const counter_t& one : health.counters) counters_[health.process_name][one.counter_name] = one.count;
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

  /// What the process last said of itself on HEALTH.
  std::string summary(const std::string& process) const {
    const auto summary = summaries_.find(process);
    return summary == summaries_.end() ? "(no HEALTH of " + process + ")" : summary->second;
  }
  /// -1: it did not say.
  std::int64_t counter(const std::string& process, const std::string& name) const {
    const auto counters = counters_.find(process);
    if (counters == counters_.end()) return -1;
    const auto counter = counters->second.find(name);
    return counter == counters->second.end() ? -1 : counter->second;
  }

 private:
  LcmBus bus_;
  // By process; HEALTH comes in several messages, each with its share of the counters.
  std::map<std::string, std::string> summaries_;
  std::map<std::string, std::map<std::string, std::int64_t>> counters_;
};

}  // namespace scanway::test
