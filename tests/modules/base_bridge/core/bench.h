#pragma once

#include <algorithm>
#include <vector>

#include "modules/base_bridge/core/base.h"
#include "tests/modules/base_bridge/test_robot.h"

namespace scanway::test {

/// The bridge's core and a test robot on one line, with a clock of their own.
struct Bench {
  explicit Bench(int baud = 38400) { robot.baud = baud; }

  void step() {
    base.receive(robot.run(now), now);
    base.tick(now);
    for (erratic::Packet packet = base.next_packet(now); !packet.empty(); packet = base.next_packet(now)) {
      sent.push_back(now);
      base.receive(robot.receive(packet, base.baud()), now);
    }
    for (auto& event : base.take_events()) events.push_back(std::move(event));
    now += 1000;
  }

  void run(double seconds) {
    for (const Utime end = now + static_cast<Utime>(seconds * 1e6); now < end;) step();
  }

  bool get_ready() {
    for (int i = 0; i < 10'000 && !base.ready(); ++i) step();
    return base.ready();
  }

  long count(erratic::BaseEvent::Kind kind) const {
    return std::count_if(events.begin(), events.end(),
                         [&](const erratic::BaseEvent& event) { return event.kind == kind; });
  }

  Utime now = 5'000'000;
  TestRobot robot;
  erratic::Base base;
  std::vector<erratic::BaseEvent> events;
  std::vector<Utime> sent;
};

}  // namespace scanway::test
