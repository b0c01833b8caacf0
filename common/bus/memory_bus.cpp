#include "common/bus/memory_bus.h"

#include <utility>

namespace scanway {

void MemoryBus::publish(std::string_view channel, std::span<const std::uint8_t> bytes, Utime utime) {
  waiting_.push_back({std::string(channel), {bytes.begin(), bytes.end()}, utime});
}

void MemoryBus::subscribe(std::string_view channel, Handler handler) {
  subscriptions_.push_back({std::string(channel), std::move(handler)});
}

std::size_t MemoryBus::dispatch() {
  std::size_t delivered = 0;
  while (!waiting_.empty()) {
    const Waiting message = std::move(waiting_.front());
    waiting_.pop_front();
    ++delivered;
    const std::size_t subscribed = subscriptions_.size();  // Who subscribes in a handler gets the next message on.
    for (std::size_t i = 0; i < subscribed; ++i) {
      if (subscriptions_[i].channel != message.channel) continue;
      subscriptions_[i].handler({message.channel, message.bytes, message.utime});
    }
  }
  return delivered;
}

}  // namespace scanway
