#pragma once

#include <algorithm>

#include "common/bus/log_writer.h"
#include "common/bus/memory_bus.h"

namespace scanway {

/// The bus of a replay: in memory, and recorded. What the nodes publish is recorded at the time of the input that made
/// them do it, so the recording's times never run back.
class ReplayBus : public Bus {
 public:
  explicit ReplayBus(LogWriter& log) : log_(log) {}

  /// The recording begins at that time.
  void begin(Utime utime) { now_ = utime; }
  /// Feeds an event of the replayed log, and lets the nodes work until nothing waits.
  void feed(std::string_view channel, std::span<const std::uint8_t> bytes, Utime utime) {
    now_ = std::max(now_, utime);
    publish(channel, bytes, utime);
    memory_.dispatch();
  }
  /// Delivers what nodes have published on their own.
  void dispatch() { memory_.dispatch(); }

  void publish(std::string_view channel, std::span<const std::uint8_t> bytes, Utime) override {
    log_.write(channel, bytes, now_);
    memory_.publish(channel, bytes, now_);
  }
  void subscribe(std::string_view channel, Handler handler) override { memory_.subscribe(channel, std::move(handler)); }

 private:
  LogWriter& log_;
  MemoryBus memory_;
  Utime now_ = 0;
};

}  // namespace scanway
