// Sweeps from raw messages on a bus: what the core assembles, whatever came first.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <string>

#include "common/random/random.h"
#include "modules/mapper/node/mapper_node.h"
#include "tests/modules/mapper/node/raw_sweep.h"
#include "tests/support/command.h"

namespace scanway::test {
namespace {

TEST(SweepAssembler, MakesWhatTheCoreMakesAndSaysOfWhat) {
  Assembler assembler;
  assembler.feed(raw_log()).finish();
  const AssembledSweep core = expected(raw_log());
  ASSERT_EQ(assembler.sweeps.size(), 1U);
  const Object& object = assembler.sweeps[0];
  EXPECT_EQ(object.bytes, encode(core.sweep));
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
  EXPECT_EQ(straight.sweeps[0].bytes, encode(expected(raw_log()).sweep));
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    Assembler mixed;
    mixed.feed(delayed(with_tail(), seed));
    ASSERT_EQ(mixed.sweeps.size(), 1U) << seed;
    EXPECT_EQ(mixed.sweeps[0].bytes, straight.sweeps[0].bytes) << seed;
    EXPECT_EQ(used(mixed.origins[0]), used(straight.origins[0])) << seed;
    for (const input_span_t& input : mixed.origins[0].inputs.inputs) EXPECT_EQ(input.late_count, 0);
  }
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

TEST(SweepAssembler, TheMapperUsesTheSweepsOwnOrientationAlsoWhenItIsStartedAgain) {
  const ScratchFolder scratch;
  const SweepStore store(scratch / "state");
  const auto run = [&](const Log& log, std::vector<std::vector<std::uint8_t>>& inputs) {
    MemoryBus bus;
    bus.subscribe(channel::kSweepInputs.name,
                  [&](const BusMessage& m) { inputs.emplace_back(m.bytes.begin(), m.bytes.end()); });
    MapperNode mapper(bus, robot());
    SweepAssembler assembler(bus, robot(), [&](SweepOrigin origin) { mapper.expect(std::move(origin)); });
    mapper.restore(store);
    for (const Said& said : log) bus.publish(said.channel, said.bytes, said.utime);
    bus.dispatch();
    assembler.finish();
    mapper.settle(true);
    EXPECT_EQ(mapper.state().settled, log.empty()) << "the sweep is on its way";
    bus.dispatch();
    mapper.settle();
    bus.dispatch();
    EXPECT_TRUE(mapper.state().settled);
    EXPECT_EQ(mapper.counters().at("mapper_late_sweeps"), 0);
    return mapper.state().map_digest;
  };
  std::vector<std::vector<std::uint8_t>> inputs, inputs_again;
  const std::int64_t map = run(raw_log(), inputs);
  EXPECT_NE(map, 0);
  EXPECT_EQ(run({}, inputs_again), map);
  ASSERT_EQ(inputs.size(), 1U);
  EXPECT_EQ(inputs_again, inputs);
  EXPECT_EQ(decode<sweep_inputs_t>(inputs[0]).inputs.size(), 4U);
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
}  // namespace scanway::test
