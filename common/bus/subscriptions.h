#pragma once

#include <algorithm>
#include <deque>
#include <string>
#include <utility>

#include "common/bus/bus.h"

namespace scanway {

/// Who wants what: handlers by the exact name of a channel.
class Subscriptions {
 public:
  void add(std::string_view channel, Bus::Handler handler) {
    subscriptions_.push_back({std::string(channel), std::move(handler)});
  }

  bool has(std::string_view channel) const {
    return std::any_of(subscriptions_.begin(), subscriptions_.end(),
                       [channel](const Subscription& one) { return one.channel == channel; });
  }

  /// Calls the channel's handlers in the order of subscribing. Who subscribes in a handler gets the next message on.
  void deliver(const BusMessage& message) {
    const std::size_t subscribed = subscriptions_.size();
    for (std::size_t i = 0; i < subscribed; ++i) {
      if (subscriptions_[i].channel == message.channel) subscriptions_[i].handler(message);
    }
  }

 private:
  struct Subscription {
    std::string channel;
    Bus::Handler handler;
  };

  std::deque<Subscription> subscriptions_;  // A deque: handlers stay in place while they subscribe others.
};

}  // namespace scanway
