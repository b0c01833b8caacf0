#include "common/bus/memory_bus.h"

#include <utility>

namespace scanway {

void MemoryBus::publish(std::string_view channel, std::span<const std::uint8_t> bytes, Utime utime) {
  waiting_.push_back({std::string(channel), {bytes.begin(), bytes.end()}, utime});
}

void MemoryBus::subscribe(std::string_view channel, Handler handler) {
  subscriptions_.add(channel, std::move(handler));
}

std::size_t MemoryBus::dispatch() {
  std::size_t delivered = 0;
  while (!waiting_.empty()) {
    const Waiting message = std::move(waiting_.front());
    waiting_.pop_front();
    ++delivered;
    subscriptions_.deliver({message.channel, message.bytes, message.utime});
  }
  return delivered;
}

}  // namespace scanway
