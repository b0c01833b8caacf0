// Sweeps from raw messages on a bus: what the core assembles, whatever came first, was lost and asked for again.
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
#include "common/random/random.h"
#include "modules/mapper/node/raw_input.h"
#include "modules/mapper/node/sweep_assembler.h"
#include "modules/sick_bridge/node/line_archive.h"
#include "modules/simulator/core/simulator.h"
#include "modules/simulator/node/raw_log.h"
#include "scanway/line_request_t.hpp"

namespace scanway {
namespace {

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

const Robot& robot() {
  static const Robot kRobot = simulator::simulated_robot();
  return kRobot;
}

/// What the bridges say of a sweep in a hall: every twelfth line and beam.
const Log& raw_log() {
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

bool is_line(const Said& said) { return said.channel == channel::kLaserLine.name; }
std::int64_t line_of(const Said& said) { return decode<laser_line_t>(said.bytes).line; }

/// The core's own result, put together without the node.
AssembledSweep expected(const Log& log) {
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
std::map<std::string, std::pair<std::int64_t, std::int64_t>> used(const SweepOrigin& origin) {
  std::map<std::string, std::pair<std::int64_t, std::int64_t>> used;
  for (const input_span_t& input : origin.inputs.inputs) used[input.channel] = {input.used_count, input.used_digest};
  return used;
}

TEST(SweepAssembler, MakesWhatTheCoreMakesAndSaysOfWhat) {
  Assembler assembler;
  assembler.feed(raw_log()).finish();
  const AssembledSweep core = expected(raw_log());
  ASSERT_EQ(assembler.sweeps.size(), 1U);
  const Object& object = assembler.sweeps[0];
  EXPECT_EQ(object.bytes, encode(to_message(core.sweep)));
  EXPECT_EQ(object.key, "sweep_7");
  ASSERT_EQ(assembler.origins.size(), 1U);
  const SweepOrigin& origin = assembler.origins[0];
  EXPECT_EQ(origin.R_world_sweep->coeffs(), core.sweep.R_world_sweep->coeffs());
  EXPECT_EQ(static_cast<std::uint64_t>(origin.inputs.sweep_digest), object.digest);
  EXPECT_EQ(origin.inputs.utime, core.sweep.utime);
  const auto pieces = std::count_if(raw_log().begin(), raw_log().end(), is_line);
  EXPECT_EQ(used(origin).at("LASER_LINE").first, pieces);
  EXPECT_EQ(used(origin).at("SWEEP_MARK").first, 2);
  EXPECT_NEAR(static_cast<double>(used(origin).at("IMU").first), 100 * 120, 2);
  EXPECT_TRUE(assembler.requests.empty());
  EXPECT_EQ(assembler.node.summary(), "");
}

/// The raw log, and how it goes on for 1.5 s with the robot as it stands.
Log with_tail() {
  Log log = raw_log();
  std::map<std::string, Log> last;  // Of a channel and time.
  for (const Said& said : log) {
    Log& same = last[said.channel];
    if (!same.empty() && same.back().utime != said.utime) same.clear();
    same.push_back(said);
  }
  const Utime end = log.back().utime;
  const auto repeat = [&]<class T>(const Channel& channel, Utime period, T message) {
    for (Said said : last[std::string(channel.name)]) {
      for (int i = 1; i * period < 3 * kMicrosecondsPerSecond / 2; ++i) {
        message = decode<T>(said.bytes);
        message.utime += i * period;
        if constexpr (requires { message.line; }) message.line += i;
        log.push_back({said.channel, encode(message), end + i * period});
      }
    }
  };
  repeat(channel::kImu, 10'000, bot_core::ins_t{});
  repeat(channel::kPanTiltState, 20'000, bot_core::joint_state_t{});
  repeat(channel::kLaserLine, 480'000, laser_line_t{});
  return log;
}

/// Each channel in its order, and as late as it may be.
Log delayed(Log log, std::uint64_t seed) {
  Random random(seed);
  std::map<std::string, Utime> delays;
  for (const Said& said : log) delays.emplace(said.channel, static_cast<Utime>(random.below(900'000)));
  std::stable_sort(log.begin(), log.end(), [&](const Said& a, const Said& b) {
    return a.utime + delays[a.channel] < b.utime + delays[b.channel];
  });
  return log;
}

TEST(SweepAssembler, TheOrderOfArrivalBetweenChannelsChangesNothing) {
  Assembler straight;
  straight.feed(with_tail());
  ASSERT_EQ(straight.sweeps.size(), 1U);
  EXPECT_EQ(straight.sweeps[0].bytes, encode(to_message(expected(raw_log()).sweep)));
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    Assembler mixed;
    mixed.feed(delayed(with_tail(), seed));
    ASSERT_EQ(mixed.sweeps.size(), 1U) << seed;
    EXPECT_EQ(mixed.sweeps[0].bytes, straight.sweeps[0].bytes) << seed;
    EXPECT_EQ(used(mixed.origins[0]), used(straight.origins[0])) << seed;
    for (const input_span_t& input : mixed.origins[0].inputs.inputs) EXPECT_EQ(input.late_count, 0);
  }
}

/// The bridge's end: keeps each line, and loses `loss` of what it sends, in pieces.
class LossyBridge {
 public:
  LossyBridge(Assembler& to, double loss) : to_(to), loss_(loss) {}

  /// `last`: no more pieces of that line will come.
  void say(const Said& said, bool last) {
    if (random_.uniform() >= loss_) to_.feed(said);
    line_.push_back(said.bytes);
    if (last) archive_.keep(std::exchange(line_, {}), said.utime);
  }
  void answer(Utime now, std::int64_t first_line) {
    for (; answered_ < to_.requests.size(); ++answered_) {
      const line_request_t& request = to_.requests[answered_];
      for (std::size_t i = 0; i < request.first_line.size(); ++i) {
        archive_.ask(request.first_line[i] - first_line, request.end_line[i] - first_line, now);
      }
    }
    archive_.pump(now, [&](const auto& message) {
      if (random_.uniform() >= loss_) to_.feed({std::string(channel::kLaserLine.name), message, now});
    });
  }
  const sick::LineArchive& archive() const { return archive_; }

 private:
  Assembler& to_;
  double loss_;
  Random random_{1};
  sick::LineArchive archive_;
  std::vector<sick::LineArchive::Message> line_;
  std::size_t answered_ = 0;
};

TEST(SweepAssembler, LinesThatWereLostAreAskedForUntilAllAreThere) {
  Assembler lossless, lossy;
  lossless.feed(raw_log()).finish();
  LossyBridge bridge(lossy, 0.3);
  const std::int64_t first = line_of(*std::find_if(raw_log().begin(), raw_log().end(), is_line));
  std::vector<std::size_t> lines;
  for (std::size_t i = 0; i < raw_log().size(); ++i) {
    if (is_line(raw_log()[i])) lines.push_back(i);
  }
  for (std::size_t i = 0, line = 0; i < raw_log().size(); ++i) {
    const Said& said = raw_log()[i];
    if (!is_line(said)) {
      lossy.feed(said);
    } else {
      ++line;
      bridge.say(said, line == lines.size() || line_of(raw_log()[lines[line]]) != line_of(said));
    }
    bridge.answer(said.utime, first);
  }
  // The tracker goes on.
  Said imu =
      *std::find_if(raw_log().rbegin(), raw_log().rend(), [](const Said& said) { return said.channel == "IMU"; });
  for (int i = 0; i < 3000 && lossy.sweeps.empty(); ++i) {
    auto message = decode<bot_core::ins_t>(imu.bytes);
    message.utime += 10'000;
    imu = {imu.channel, encode(message), imu.utime + 10'000};
    lossy.feed(imu);
    bridge.answer(imu.utime, first);
  }
  ASSERT_EQ(lossy.sweeps.size(), 1U);
  EXPECT_EQ(lossy.sweeps[0].bytes, lossless.sweeps[0].bytes);
  EXPECT_EQ(used(lossy.origins[0]), used(lossless.origins[0]));
  EXPECT_GT(bridge.archive().counters().lines_resent, 50);
  EXPECT_EQ(lossy.node.counters().at("assembler_missing_lines"), 0);
  EXPECT_LT(lossy.node.counters().at("assembler_lines_asked"), 3 * bridge.archive().counters().lines_resent);
}

TEST(SweepAssembler, LinesThatNeverComeAreCountedAfterABound) {
  Log log;
  for (const Said& said : raw_log()) {
    if (!is_line(said) || line_of(said) < 120 || line_of(said) > 124) log.push_back(said);
  }
  Assembler assembler;
  assembler.feed(log);
  EXPECT_TRUE(assembler.sweeps.empty()) << "they may still come";
  EXPECT_TRUE(assembler.node.busy());
  EXPECT_NE(assembler.node.summary().find("waits for its data"), std::string::npos);
  Said imu = *std::find_if(log.rbegin(), log.rend(), [](const Said& said) { return said.channel == "IMU"; });
  auto message = decode<bot_core::ins_t>(imu.bytes);
  message.utime += 41 * kMicrosecondsPerSecond;
  assembler.feed({imu.channel, encode(message), 0});
  ASSERT_EQ(assembler.sweeps.size(), 1U);
  EXPECT_EQ(assembler.sweeps[0].bytes, encode(to_message(expected(log).sweep)));
  EXPECT_EQ(assembler.node.counters().at("assembler_missing_lines"), 5);
  EXPECT_LE(assembler.node.counters().at("assembler_lines_asked"), 5 * 10) << "asked for with a cap";
  EXPECT_EQ(assembler.node.summary(), "sweep_7: lacks 5 lines");
  ASSERT_FALSE(assembler.requests.empty());
  EXPECT_EQ(assembler.requests[0].first_line[0], 120);

  Said late =
      *std::find_if(raw_log().begin(), raw_log().end(), [](const Said& s) { return is_line(s) && line_of(s) == 121; });
  assembler.feed(late);
  EXPECT_EQ(assembler.node.counters().at("assembler_late_lines"), 1);
  EXPECT_EQ(assembler.sweeps.size(), 1U);
}

TEST(SweepAssembler, InSilenceItAsksAFewTimesAndThenTakesWhatIsThere) {
  Log log;
  for (const Said& said : raw_log()) {
    if (!is_line(said) || line_of(said) != 348) log.push_back(said);
  }
  Assembler assembler;
  assembler.feed(log);
  const std::size_t before = assembler.requests.size();
  for (int i = 0; i < 10 && assembler.sweeps.empty(); ++i) {
    assembler.node.settle();
    assembler.bus.dispatch();
  }
  EXPECT_EQ(assembler.sweeps.size(), 1U);
  EXPECT_GE(assembler.requests.size(), before + 2);
  EXPECT_FALSE(assembler.node.busy());
}

Log with_marks(const std::function<void(sweep_mark_t&)>& change) {
  Log log = raw_log();
  for (Said& said : log) {
    if (said.channel != channel::kSweepMark.name) continue;
    auto mark = decode<sweep_mark_t>(said.bytes);
    change(mark);
    said.bytes = encode(mark);
  }
  return log;
}

TEST(SweepAssembler, ASweepThatIsGivenUpIsDroppedAndSaid) {
  Assembler assembler;
  assembler
      .feed(with_marks([](sweep_mark_t& mark) {
        if (mark.mark == sweep_mark_t::STARTED) return;
        mark.mark = sweep_mark_t::ABORTED;
        mark.reason = "the pan is blocked";
      }))
      .finish();
  EXPECT_TRUE(assembler.sweeps.empty());
  EXPECT_FALSE(assembler.node.busy());
  EXPECT_EQ(assembler.node.counters().at("assembler_sweeps_aborted"), 1);
  EXPECT_NE(assembler.node.summary().find("sweep_7 was given up by the pan-tilt: the pan is blocked"),
            std::string::npos);
}

TEST(SweepAssembler, MarksThatAreSaidAgainMakeNoSecondSweep) {
  Log marks;
  for (const Said& said : raw_log()) {
    if (said.channel == channel::kSweepMark.name) marks.push_back(said);
  }
  Assembler assembler;
  assembler.feed(raw_log()).finish().feed(marks).feed(raw_log()).finish();
  EXPECT_EQ(assembler.sweeps.size(), 1U);
  Assembler started_late;  // Hears only that a sweep has ended.
  started_late.feed(marks[1]);
  EXPECT_FALSE(started_late.node.busy());
  started_late.finish();
  EXPECT_TRUE(started_late.origins.empty());
}

TEST(SweepAssembler, ARobotThatMovesDuringTheSweepIsNoticed) {
  Log log = raw_log();
  for (std::size_t i = log.size() / 2; i < log.size(); ++i) {
    if (log[i].channel != channel::kImu.name) continue;
    const auto imu = decode<bot_core::ins_t>(log[i].bytes);
    const Eigen::Quaterniond turned = Eigen::AngleAxisd(0.01, Eigen::Vector3d::UnitZ()) * orientation_of(imu);
    log[i].bytes = encode(imu_message(imu.utime, turned));
  }
  Assembler assembler;
  assembler.feed(log).finish();
  EXPECT_EQ(assembler.sweeps.size(), 1U);
  EXPECT_EQ(assembler.node.counters().at("assembler_sweeps_moved"), 1);
  EXPECT_NE(assembler.node.summary().find("the robot moved during it, by 0.5"), std::string::npos)
      << assembler.node.summary();
}

TEST(SweepAssembler, FalseMessagesAreCountedAndSpoilNothing) {
  Assembler clean, assembler;
  clean.feed(raw_log()).finish();
  Random random(3);
  for (const Said& said : raw_log()) {
    if (random.uniform() < 0.05) {
      Said bad = said;
      bad.bytes.resize(bad.bytes.size() / 2);
      assembler.feed(bad);
      laser_line_t line{};
      line.utime = std::int64_t{1} << 62;
      assembler.feed({"LASER_LINE", encode(line), 0});
      line.utime = said.utime;
      line.beam_period_us = 1e300;
      line.nbeams_of_line = 5;
      assembler.feed({"LASER_LINE", encode(line), 0});
    }
    assembler.feed(said);
  }
  assembler.finish();
  ASSERT_EQ(assembler.sweeps.size(), 1U);
  EXPECT_EQ(assembler.sweeps[0].bytes, clean.sweeps[0].bytes);
  EXPECT_GT(assembler.node.counters().at("assembler_bad_messages"), 100);
}

}  // namespace
}  // namespace scanway
