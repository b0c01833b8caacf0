#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string_view>

#include "common/time/utime.h"

namespace scanway {

/// An encoded message on its way. It is borrowed: a handler that keeps any of it copies it.
struct BusMessage {
  std::string_view channel;
  std::span<const std::uint8_t> bytes;
  /// When it was sent, in the bus's time: data time in replay, the wall clock live. Nothing but logs may depend on it.
  Utime utime = 0;
};

/// What a node knows of the world outside: where it publishes encoded messages, and where it gets them from.
/// Not thread-safe: all calls and all handlers belong to one thread.
class Bus {
 public:
  using Handler = std::function<void(const BusMessage&)>;

  virtual ~Bus() = default;
  virtual void publish(std::string_view channel, std::span<const std::uint8_t> bytes, Utime utime) = 0;
  /// `handler` gets every message published to `channel` (the exact name) from now on, in the order of publishing.
  /// A handler may publish and subscribe.
  virtual void subscribe(std::string_view channel, Handler handler) = 0;
};

}  // namespace scanway
