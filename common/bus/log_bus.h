#pragma once

#include <cstddef>
#include <functional>

#include "common/bus/bus.h"
#include "common/bus/log_reader.h"
#include "common/bus/log_writer.h"

namespace scanway {

/// A bus whose publications go into a log as well as to another bus.
class RecordingBus : public Bus {
 public:
  /// Both must outlive this.
  RecordingBus(Bus& bus, LogWriter& log) : bus_(bus), log_(log) {}
  void publish(std::string_view channel, std::span<const std::uint8_t> bytes, Utime utime) override {
    log_.write(channel, bytes, utime);
    bus_.publish(channel, bytes, utime);
  }
  void subscribe(std::string_view channel, Handler handler) override { bus_.subscribe(channel, std::move(handler)); }

 private:
  Bus& bus_;
  LogWriter& log_;
};

/// A bus that is only a log: publications are written, subscribers never hear anything.
class LogBus : public Bus {
 public:
  /// `log` must outlive this.
  explicit LogBus(LogWriter& log) : log_(log) {}
  void publish(std::string_view channel, std::span<const std::uint8_t> bytes, Utime utime) override {
    log_.write(channel, bytes, utime);
  }
  void subscribe(std::string_view, Handler) override {}

 private:
  LogWriter& log_;
};

/// Publishes a log's events to `bus`, each at its own time, those of the channels that `wanted` says (all, if it is
/// empty); `after_each` is called after each of them, to let the bus deliver. Returns the number of events published.
inline std::size_t feed(LogReader& log, Bus& bus, const std::function<void()>& after_each = {},
                        const std::function<bool(std::string_view)>& wanted = {}) {
  std::size_t published = 0;
  while (const auto event = log.next()) {
    if (wanted && !wanted(event->channel)) continue;
    bus.publish(event->channel, event->bytes, event->utime);
    ++published;
    if (after_each) after_each();
  }
  return published;
}

}  // namespace scanway
