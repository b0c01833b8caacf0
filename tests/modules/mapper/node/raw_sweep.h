#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "common/bus/memory_bus.h"
#include "common/messages/codec.h"
#include "common/messages/digest.h"
#include "common/messages/imu_message.h"
#include "common/messages/object_assembler.h"
#include "common/messages/sweep_message.h"
#include "modules/mapper/node/raw_input.h"
#include "modules/mapper/node/sweep_assembler.h"
#include "modules/simulator/core/simulator.h"
#include "modules/simulator/node/raw_log.h"
#include "scanway/line_request_t.hpp"

/// A simulated sweep as raw messages, and an assembler that hears them.
namespace scanway::test {

struct Said {
  std::string channel;
  std::vector<std::uint8_t> bytes;
  Utime utime = 0;
};
using Log = std::vector<Said>;

class RecordingBus : public Bus {
 public:
  void publish(std::string_view channel, std::span<const std::uint8_t> bytes, Utime utime) override {
    log.push_back({std::string(channel), {bytes.begin(), bytes.end()}, utime});
  }
  void subscribe(std::string_view, Handler) override {}

  Log log;
};

inline const Robot& robot() {
  static const Robot kRobot = simulator::simulated_robot();
  return kRobot;
}

/// What the bridges say of a sweep in a hall: every twelfth line and beam.
inline const Log& raw_log() {
  static const Log kLog = [] {
    const simulator::World world = simulator::make_world("hall", 3);
    const simulator::Stand stand = simulator::stand_at(world, robot(), {-6, 0.3, 0.5});
    simulator::SweepConfig config;
    config.thin = 12;
    RecordingBus bus;
    simulator::publish_raw_sweep(bus, simulate_lines(world, robot(), stand.X_world_base, config),
                                 simulator::Tracker(robot().tracker, stand.X_world_base, 1), {7, 100, config.start});
    return bus.log;
  }();
  return kLog;
}

inline bool is_line(const Said& said) { return said.channel == channel::kLaserLine.name; }
inline std::int64_t line_of(const Said& said) { return decode<laser_line_t>(said.bytes).line; }

/// The core's own result, put together without the node.
inline AssembledSweep expected(const Log& log) {
  AssemblyInput input;
  LineCollector collector;
  for (const Said& said : log) {
    if (is_line(said)) collector.add(piece_of(decode<laser_line_t>(said.bytes)));
    if (said.channel == channel::kPanTiltState.name) {
      input.angles.push_back(angles_of(decode<bot_core::joint_state_t>(said.bytes)));
    } else if (said.channel == channel::kImu.name) {
      const auto imu = decode<bot_core::ins_t>(said.bytes);
      input.orientations.push_back({imu.utime, orientation_of(imu)});
    } else if (said.channel == channel::kSweepMark.name) {
      const auto mark = decode<sweep_mark_t>(said.bytes);
      (mark.mark == sweep_mark_t::STARTED ? input.started : input.ended) = mark.utime;
      input.sweep = mark.sweep;
    }
  }
  input.lines = collector.take();
  return assemble(input, robot());
}

/// A node, and what it says.
class Assembler {
 public:
  Assembler() : node(bus, robot(), [this](SweepOrigin origin) { origins.push_back(std::move(origin)); }) {
    bus.subscribe(channel::kSweep.name, [this](const BusMessage& message) {
      if (auto object = pieces_.add(decode<piece_t>(message.bytes))) sweeps.push_back(std::move(*object));
    });
    bus.subscribe(channel::kLineRequest.name, [this](const BusMessage& message) {
      requests.push_back(decode<line_request_t>(message.bytes));
      EXPECT_LE(message.bytes.size(), 1300U);
    });
  }
  void feed(const Said& said) {
    bus.publish(said.channel, said.bytes, said.utime);
    bus.dispatch();
  }
  Assembler& feed(const Log& log) {
    for (const Said& said : log) feed(said);
    return *this;
  }
  Assembler& finish() {
    node.finish();
    bus.dispatch();
    return *this;
  }

  MemoryBus bus;
  std::vector<SweepOrigin> origins;
  std::vector<Object> sweeps;
  std::vector<line_request_t> requests;
  SweepAssembler node;

 private:
  ObjectAssembler pieces_;
};

/// What was used, by channel: all but what came too late.
inline std::map<std::string, std::pair<std::int64_t, std::int64_t>> used(const SweepOrigin& origin) {
  std::map<std::string, std::pair<std::int64_t, std::int64_t>> used;
  for (const input_span_t& input : origin.inputs.inputs) used[input.channel] = {input.used_count, input.used_digest};
  return used;
}

}  // namespace scanway::test
