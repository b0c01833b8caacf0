#pragma once

#include <cstddef>
#include <deque>
#include <string>
#include <vector>

#include "common/bus/bus.h"
#include "common/bus/subscriptions.h"

namespace scanway {

/// A bus within the process: messages wait, first in first out, until dispatch() delivers them.
class MemoryBus : public Bus {
 public:
  void publish(std::string_view channel, std::span<const std::uint8_t> bytes, Utime utime) override;
  void subscribe(std::string_view channel, Handler handler) override;

  /// Delivers what waits, and what handlers publish meanwhile, until nothing waits. Returns the number delivered.
  /// When a handler throws, its message counts as delivered and the rest waits on.
  std::size_t dispatch();

 private:
  struct Waiting {
    std::string channel;
    std::vector<std::uint8_t> bytes;
    Utime utime;
  };

  std::deque<Waiting> waiting_;
  Subscriptions subscriptions_;
};

}  // namespace scanway
