#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>

#include "common/time/utime.h"
#include "modules/simulator/device/tracker/output.h"
#include "modules/simulator/device/tracker/xbus.h"

namespace scanway::simulator {

/// An MTi as the host hears it: bytes in, bytes out, its own clock as an argument (microseconds since it was switched
/// on).
class TrackerEmulator {
 public:
  using Sense = std::function<TrackerSample(std::int64_t sample, Utime time)>;

  enum class Generation : std::uint8_t { older, current };  ///< MTData, MTData2.

  explicit TrackerEmulator(Sense sense, Generation generation = Generation::current);

  /// Its answers.
  XbusBytes receive(std::span<const std::uint8_t> bytes, Utime now);
  /// What it sends unasked by now: the greeting after it was switched on, and measurements.
  XbusBytes tick(Utime now);

  /// Lives `speed` seconds in one second of the host, and from now on tells its times by the host's.
  void tell_host_time(double speed) { speed_ = speed; }

  /// Switched off and on: its clock and its counter begin anew, its settings stay.
  void reboot();

  bool measuring() const { return state_ == State::measuring; }

 private:
  enum class State : std::uint8_t { off, waking, configuring, measuring };
  XbusBytes answer(const XbusRequest& request, Utime now);
  XbusBytes answer_in_configuration(const XbusRequest& request);
  XbusBytes configuration() const;
  XbusBytes measure(Utime time);
  void start_measuring(Utime now);

  Sense sense_;
  XbusRequests requests_;
  State state_ = State::off;
  Utime woke_ = 0, began_ = 0;
  std::int64_t sample_ = 0;  // Since it began to measure.
  std::uint16_t counter_ = 0;
  double speed_ = 1.0;
  std::unique_ptr<TrackerOutput> output_;
};

}  // namespace scanway::simulator
