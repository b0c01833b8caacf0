#pragma once

#include <limits>
#include <map>
#include <string>
#include <vector>

#include "bot_core/joint_state_t.hpp"
#include "common/bus/channels.h"
#include "common/bus/memory_bus.h"
#include "common/messages/codec.h"
#include "modules/schunk_bridge/node/pan_tilt_node.h"
#include "scanway/sweep_mark_t.hpp"
#include "tests/modules/schunk_bridge/core/bench_of_two.h"

namespace scanway::test {

inline constexpr double kNotSaid = std::numeric_limits<double>::quiet_NaN();
inline constexpr Utime kTurn = 10'000;

inline pan_tilt_command_t command_of(std::int8_t command) {
  pan_tilt_command_t message{};
  message.command = command;
  message.pan_rad = message.tilt_rad = message.pan_speed_rad_s = message.tilt_speed_rad_s = kNotSaid;
  return message;
}

inline pan_tilt_command_t sweep_at(double degrees_a_second) {
  pan_tilt_command_t message = command_of(pan_tilt_command_t::SWEEP);
  message.pan_speed_rad_s = radians(degrees_a_second);
  return message;
}

/// Turns of 10 ms: what the modules say in one is handed over at its end, with the times at which it came.
struct NodeBench {
  static constexpr Utime kStarted = 999'000'000;  ///< When the numbering of the sweeps began.

  explicit NodeBench(TestModule::Units units = TestModule::kDegrees, const schunk::PanTiltConfig& config = {})
      : pan(11, units, true), tilt(12, units, true), core(config) {
    bus.subscribe(channel::kPanTiltState.name, [this](const BusMessage& message) {
      states.push_back(decode<bot_core::joint_state_t>(message.bytes));
    });
    bus.subscribe(channel::kSweepMark.name,
                  [this](const BusMessage& message) { marks.push_back(decode<sweep_mark_t>(message.bytes)); });
    run_until([&] { return states.size() > 3; }, 5);
  }

  void turn() {
    bus.dispatch();
    node.obey(now);
    send();
    for (const Utime end = now + kTurn; now < end; now += 1000) {
      for (TestModule* module : {&pan, &tilt}) receive(module->run(now));
      truth[now] = radians(pan.angle());
    }
    core.tick(now);
    send();
    node.tell(now);
    bus.dispatch();
  }
  void send() {
    for (int i = 0; i < 5; ++i) {
      const auto frame = core.next_frame(now + i * 1000);
      if (!frame) continue;
      commands.push_back(frame->data[1]);
      for (TestModule* module : {&pan, &tilt}) receive(module->handle(from_can(*frame), now));
    }
  }
  void receive(const std::vector<TestFrame>& frames) {
    for (const auto& frame : frames) core.receive(to_can(frame), now);
  }
  void run(double seconds) {
    for (const Utime end = now + static_cast<Utime>(seconds * 1e6); now < end;) turn();
  }
  template <class Done>
  bool run_until(const Done& done, double limit_s = 300) {
    for (const Utime end = now + static_cast<Utime>(limit_s * 1e6); now < end; turn()) {
      if (done()) return true;
    }
    return false;
  }
  void say(pan_tilt_command_t command) {
    command.utime = now;
    bus.publish(channel::kPanTiltCommand.name, encode(command), now);
    turn();
  }
  bool marked(std::int8_t mark) {
    return run_until([&] { return !marks.empty() && marks.back().mark == mark; });
  }
  std::int64_t counter(const std::string& name) const { return node.counters().at("schunk_" + name); }

  Utime now = 1'000'000'000;
  MemoryBus bus;
  TestModule pan, tilt;
  schunk::PanTilt core;
  schunk::PanTiltNode node{bus, core, kStarted};
  std::map<Utime, double> truth;
  std::vector<std::uint8_t> commands;
  std::vector<bot_core::joint_state_t> states;
  std::vector<sweep_mark_t> marks;
};

}  // namespace scanway::test
