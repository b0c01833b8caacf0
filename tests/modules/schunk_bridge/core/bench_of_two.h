#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "modules/schunk_bridge/core/pan_tilt.h"
#include "tests/modules/schunk_bridge/support/test_module.h"

namespace scanway::test {

inline CanFrame to_can(const TestFrame& frame) {
  CanFrame can;
  can.id = frame.id;
  can.size = static_cast<std::uint8_t>(frame.bytes.size());
  std::copy(frame.bytes.begin(), frame.bytes.end(), can.data.begin());
  return can;
}

inline TestFrame from_can(const CanFrame& can) { return {can.id, {can.data.begin(), can.data.begin() + can.size}}; }

/// The bridge's core and two test modules on a table, with a clock of their own.
struct BenchOfTwo {
  using Kind = schunk::Event::Kind;

  explicit BenchOfTwo(TestModule::Units units = TestModule::kDegrees, bool referenced = true,
                      const schunk::PanTiltConfig& config = {})
      : pan(11, units, referenced), tilt(12, units, referenced), bridge(config) {}

  /// Runs a millisecond at a time.
  void run(double seconds) {
    for (const Utime end = now + static_cast<Utime>(seconds * 1e6); now < end; now += 1000) step();
  }

  template <class Done>
  bool run_until(const Done& done, double limit_s = 400) {
    for (const Utime end = now + static_cast<Utime>(limit_s * 1e6); now < end; now += 1000) {
      if (done()) return true;
      step();
    }
    return false;
  }

  bool get_ready() {
    return run_until(
        [&] {
          return bridge.pan().phase() == schunk::Axis::Phase::ready &&
                 bridge.tilt().phase() == schunk::Axis::Phase::ready;
        },
        5);
  }

  void step() {
    for (TestModule* module : {&pan, &tilt}) deliver(module->run(now));
    bridge.tick(now);
    while (const auto frame = bridge.next_frame(now)) {
      sent.push_back({now, *frame});
      for (TestModule* module : {&pan, &tilt}) deliver(module->handle(from_can(*frame), now));
    }
    for (auto& event : bridge.take_events()) events.push_back(std::move(event));
  }

  void deliver(const std::vector<TestFrame>& frames) {
    for (const TestFrame& frame : frames) bridge.receive(to_can(frame), now);
  }

  const schunk::Event* find(Kind kind, const std::string& axis = "") const {
    const auto found = std::find_if(events.begin(), events.end(), [&](const schunk::Event& event) {
      return event.kind == kind && (axis.empty() || event.axis == axis);
    });
    return found == events.end() ? nullptr : &*found;
  }

  struct Sent {
    Utime utime;
    CanFrame frame;
  };

  Utime now = 1'000'000'000;
  TestModule pan, tilt;
  schunk::PanTilt bridge;
  std::vector<schunk::Event> events;
  std::vector<Sent> sent;
};

}  // namespace scanway::test
