#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "common/clock/back_off.h"
#include "common/serial/serial_port.h"
#include "common/time/device_clock.h"
#include "modules/xsens_bridge/core/dialogue.h"
#include "modules/xsens_bridge/core/reading.h"

namespace scanway::xsens {

struct TrackerAddress {
  std::string port = "/dev/ttyUSB0";
  int baud = 0;  ///< 0: found out, the factory's 115200 first.
};

/// A reading, and when it was measured.
struct TimedReading {
  TrackerReading reading;
  Utime utime = 0;
};

/// What came since the last call.
struct TrackerNews {
  std::vector<TimedReading> readings;  ///< Those without orientation as well.
  std::vector<std::string> notes;      ///< What a person should know, a line each.
};

/// A tracker that is kept running: its port opened, its rate found out, set up, and all of that anew with growing
/// pauses whenever it is gone, absent, slow or silent. Never throws for what the tracker does.
class TrackerDevice {
 public:
  TrackerDevice(const TrackerAddress& address, const TrackerConfig& config, const TrackerAccuracy& accuracy = {});

  /// Waits at most `timeout_ms` for the tracker, and does what is due.
  TrackerNews run(int timeout_ms);

  bool measuring() const { return dialogue_ && dialogue_->state() == Dialogue::State::measuring; }
  /// Since the port was opened, or nothing while it is not.
  const Dialogue* dialogue() const { return dialogue_ ? &*dialogue_ : nullptr; }
  /// Why it does not measure, in one line; empty: it is not known to fail.
  const std::string& trouble() const { return back_off_.reason(); }
  const std::string& port() const { return address_.port; }
  /// Of the open port, or 0.
  int baud() const { return port_ ? port_->baud() : 0; }
  /// Since the start, over all openings of the port.
  TrackerCounters counters() const;
  /// Data messages that could not be read.
  std::uint64_t bad_messages() const { return bad_messages_; }
  std::int64_t openings() const { return openings_; }
  std::int64_t clock_jumps() const { return clock_.jumps(); }

 private:
  int next_baud();
  void open_if_due(Utime now);
  void talk(Utime now, int timeout_ms, TrackerNews& news);
  void doubt_baud(Utime now, TrackerNews& news);
  void read(const DataMessage& data, TrackerNews& news);
  std::vector<Item> items_of(const Message& message) const;
  Utime time_of(const TrackerReading& reading, Utime arrival);
  void close();
  std::string advice() const;
  void give_up(const std::string& reason, Utime now, TrackerNews& news);

  TrackerAddress address_;
  TrackerConfig config_;
  TrackerAccuracy accuracy_;
  std::optional<SerialPort> port_;
  std::optional<Dialogue> dialogue_;
  DeviceClockModel model_;
  DeviceClock clock_;
  TrackerCounters earlier_;  // Of openings that are over.
  std::uint64_t bad_messages_ = 0;
  std::size_t baud_index_ = 0;
  Utime opened_ = 0;
  BackOff back_off_{kMicrosecondsPerSecond / 4, 4 * kMicrosecondsPerSecond};
  std::int64_t openings_ = 0;
};

}  // namespace scanway::xsens
