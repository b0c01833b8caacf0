// The pan-tilt's node on a bus in memory, with two test modules on a wire in memory and a clock of its own.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/modules/schunk_bridge/node/node_bench.h"

namespace scanway {
namespace {

using test::command_of;
using test::NodeBench;
using test::sweep_at;
using test::TestModule;
using Command = pan_tilt_command_t;

class InEveryUnit : public testing::TestWithParam<TestModule::Units> {};

TEST_P(InEveryUnit, ThePanAngleOfABeamIsKnownToFiveThousandthsOfADegree) {
  NodeBench bench(GetParam());
  bench.say(sweep_at(3));
  ASSERT_TRUE(bench.marked(sweep_mark_t::STARTED));
  bench.run(1);
  const std::size_t first = bench.states.size();
  bench.run(30);
  double worst = 0;
  for (std::size_t i = first; i < bench.states.size(); ++i) {
    const auto& before = bench.states[i - 1];
    const auto& after = bench.states[i];
    // Evenly spaced (the module steps by milliseconds), each at its own time however late it was fetched.
    ASSERT_NEAR(static_cast<double>(after.utime - before.utime), 20'000, 1'000);
    const double a = static_cast<double>(before.joint_position[0]), b = static_cast<double>(after.joint_position[0]);
    for (Utime beam = before.utime; beam < after.utime; beam += 1000) {
      const double share = to_seconds(beam - before.utime) / to_seconds(after.utime - before.utime);
      worst = std::max(worst, std::fabs(a + share * (b - a) - bench.truth.at(beam)));
    }
  }
  EXPECT_GT(bench.states.size() - first, 1480u);
  EXPECT_GT(worst, 0);
  EXPECT_LE(worst, radians(0.005));
  EXPECT_EQ(bench.counter("state_gaps"), 0);
}
INSTANTIATE_TEST_SUITE_P(PanTiltNode, InEveryUnit,
                         testing::Values(TestModule::kDegrees, TestModule::kRadians, TestModule::kMillidegrees));

TEST(PanTiltNode, TellsBothJointsAndCountsGaps) {
  NodeBench bench;
  bench.tilt.tilt_by(2.5);
  bench.run(0.1);
  const auto& state = bench.states.back();
  ASSERT_EQ(state.num_joints, 2);
  EXPECT_EQ(state.joint_name, (std::vector<std::string>{"pan", "tilt"}));
  EXPECT_FLOAT_EQ(state.joint_position[0], static_cast<float>(radians(10)));
  EXPECT_FLOAT_EQ(state.joint_position[1], static_cast<float>(radians(12.5)));
  EXPECT_EQ(state.joint_velocity[0], 0.0F);
  EXPECT_TRUE(std::isnan(state.joint_effort[1]));
  bench.pan.powered = false;
  bench.run(0.1);
  bench.pan.powered = true;
  bench.run(0.1);
  EXPECT_EQ(bench.counter("state_gaps"), 1);
}

TEST(PanTiltNode, MarksASweepFromItsStartToItsEnd) {
  schunk::PanTiltConfig config;
  config.sweep.start = radians(-45);
  config.sweep.angle = radians(90);
  NodeBench bench(TestModule::kDegrees, config);
  Command command = sweep_at(30);
  command.tilt_rad = radians(-5);
  bench.say(command);
  ASSERT_TRUE(bench.marked(sweep_mark_t::ENDED));
  ASSERT_EQ(bench.marks.size(), 2u);
  const sweep_mark_t& start = bench.marks[0];
  const sweep_mark_t& end = bench.marks[1];
  EXPECT_EQ(start.mark, sweep_mark_t::STARTED);
  EXPECT_EQ(start.sweep, 1);
  EXPECT_EQ(start.numbered_since, NodeBench::kStarted);
  EXPECT_NEAR(start.pan_rad, radians(-45), radians(0.01));
  EXPECT_NEAR(end.pan_rad, radians(45), radians(0.01));
  EXPECT_NEAR(to_seconds(end.utime - start.utime), 3, 0.05);
  EXPECT_NEAR(end.tilt_rad, radians(-5), radians(0.01));
  EXPECT_DOUBLE_EQ(end.pan_speed_rad_s, radians(30));
  EXPECT_DOUBLE_EQ(end.sweep_angle_rad, radians(90));
  EXPECT_EQ(end.reason, "");
  // A mark's angle is the one at its time.
  EXPECT_NEAR(bench.truth.at(start.utime), start.pan_rad, 1e-6);
  EXPECT_NEAR(bench.truth.at(end.utime), end.pan_rad, 1e-6);
  // On its way back it is stopped: the sweep is whole all the same.
  bench.run(0.5);
  bench.say(command_of(Command::STOP));
  bench.run(0.5);
  EXPECT_EQ(bench.marks.size(), 2u);
  EXPECT_FALSE(bench.core.sweep().active());
  EXPECT_FALSE(bench.pan.moving());
  // The next one is as configured again.
  bench.say(command_of(Command::SWEEP));
  ASSERT_TRUE(bench.marked(sweep_mark_t::STARTED));
  EXPECT_EQ(bench.marks.back().sweep, 2);
  EXPECT_DOUBLE_EQ(bench.marks.back().pan_speed_rad_s, radians(3));
  EXPECT_NEAR(bench.marks.back().tilt_rad, 0, radians(0.01));
  EXPECT_EQ(bench.counter("sweeps_ended"), 1);
}

TEST(PanTiltNode, SaysWhyASweepWasGivenUp) {
  NodeBench bench;
  bench.say(sweep_at(30));
  ASSERT_TRUE(bench.marked(sweep_mark_t::STARTED));
  bench.receive(bench.pan.fail(0xDA));
  bench.run(0.1);
  ASSERT_EQ(bench.marks.back().mark, sweep_mark_t::ABORTED);
  EXPECT_EQ(bench.marks.back().reason, "pan has error DA TOW");
  EXPECT_NE(bench.node.summary(bench.now).find("pan has error DA TOW"), std::string::npos);
  EXPECT_EQ(bench.counter("sweeps_aborted"), 1);
  EXPECT_EQ(bench.counter("errors"), 1);
  bench.say(command_of(Command::ACKNOWLEDGE));
  bench.run(0.1);
  EXPECT_EQ(bench.node.summary(bench.now), "");
}

TEST(PanTiltNode, SaysWhatItRefusesAndWhy) {
  NodeBench bench;
  const auto refused = [&](const Command& command, const std::string& why) {
    const auto before = bench.counter("commands_refused");
    const Utime said = bench.now;
    bench.say(command);
    EXPECT_EQ(bench.counter("commands_refused"), before + 1) << why;
    EXPECT_EQ(bench.counter("last_command"), said);
    EXPECT_EQ(bench.counter("last_command_refused"), 1);
    EXPECT_NE(bench.node.summary(bench.now).find(why), std::string::npos) << bench.node.summary(bench.now);
  };
  refused(command_of(99), "there is no such command");
  refused(command_of(Command::MOVE), "it says no angle");
  refused(command_of(Command::VELOCITY), "it says no speed");
  refused(sweep_at(130), "none that the pan axis can go at");
  refused(sweep_at(0), "none that the pan axis can go at");
  refused(sweep_at(std::numeric_limits<double>::infinity()), "none that the pan axis can go at");
  Command command = command_of(Command::SWEEP);
  command.tilt_rad = radians(125);
  refused(command, "tilt is beyond");
  command = command_of(Command::MOVE);
  command.pan_rad = radians(401);  // The module's own limit is 400.
  refused(command, "its limits are -400.00 and 400.00 deg");
  command.pan_rad = std::numeric_limits<double>::infinity();
  refused(command, "its limits are");
  command = command_of(Command::VELOCITY);
  command.tilt_speed_rad_s = radians(-121);
  refused(command, "its limit is 120.00 deg/s");
  bench.say(sweep_at(30));
  ASSERT_TRUE(bench.marked(sweep_mark_t::STARTED));
  refused(sweep_at(30), "a sweep is under way");
  bench.pan.powered = bench.tilt.powered = false;
  bench.run(2);
  refused(sweep_at(30), "does not answer");
  bench.run(11);
  EXPECT_EQ(bench.node.summary(bench.now), "pan does not answer; tilt does not answer");
  bench.bus.publish(channel::kPanTiltCommand.name, std::vector<std::uint8_t>{1, 2, 3}, bench.now);
  bench.turn();
  EXPECT_EQ(bench.counter("bad_messages"), 1);
}

TEST(PanTiltNode, ACommandThatComesTwiceIsCarriedOutOnce) {
  NodeBench bench;
  Command command = command_of(Command::MOVE);
  command.utime = 5;
  command.pan_rad = radians(20);
  for (int i = 0; i < 3; ++i) {
    bench.bus.publish(channel::kPanTiltCommand.name, encode(command), bench.now);
    bench.run(0.1);
  }
  EXPECT_EQ(bench.counter("commands"), 1);
  EXPECT_EQ(bench.counter("commands_refused"), 0);
  EXPECT_EQ(bench.pan.move_targets.size(), 1u);
  // A stop is always a stop.
  command = command_of(Command::STOP);
  command.utime = 6;
  for (int i = 0; i < 3; ++i) {
    bench.bus.publish(channel::kPanTiltCommand.name, encode(command), bench.now);
    bench.run(0.1);
  }
  EXPECT_EQ(std::count(bench.commands.begin(), bench.commands.end(), 0x91), 6);  // For both axes.
}

TEST(PanTiltNode, MovesBothAxesAndStopsThem) {
  NodeBench bench;
  Command command = command_of(Command::MOVE);
  command.pan_rad = radians(60);
  command.tilt_rad = radians(-20);
  command.pan_speed_rad_s = radians(20);
  bench.say(command);
  bench.run(1);
  EXPECT_NEAR(bench.pan.speed(), 20, 1e-3);
  EXPECT_NEAR(bench.tilt.speed(), -30, 1e-3);
  bench.run(3);
  EXPECT_NEAR(bench.pan.angle(), 60, 1e-3);
  EXPECT_NEAR(bench.tilt.angle(), -20, 1e-3);
  command = command_of(Command::VELOCITY);
  command.pan_speed_rad_s = radians(-15);
  bench.say(command);
  bench.run(1);
  EXPECT_NEAR(bench.pan.speed(), -15, 1e-3);
  EXPECT_TRUE(bench.pan.moving());
  bench.say(command_of(Command::STOP));
  bench.run(0.1);
  EXPECT_FALSE(bench.pan.moving());
  EXPECT_NEAR(bench.pan.angle(), 45, 0.7);
  bench.say(command_of(Command::FAST_STOP));
  bench.run(0.1);
  EXPECT_EQ(bench.pan.error(), 0xD9);
  EXPECT_EQ(bench.tilt.error(), 0xD9);
  EXPECT_NE(bench.node.summary(bench.now).find("D9 FAST STOP"), std::string::npos);
}

TEST(PanTiltNode, ATurnEndsBeforeTheLimit) {
  for (const double speed : {100.0, -100.0, 7.0}) {
    NodeBench bench;
    Command command = command_of(Command::VELOCITY);
    command.pan_speed_rad_s = radians(speed);
    bench.say(command);
    ASSERT_TRUE(bench.run_until([&] { return !bench.core.pan().motion().under_way(); })) << speed;
    bench.run(0.1);
    EXPECT_FALSE(bench.pan.moving());
    EXPECT_LT(std::fabs(bench.pan.angle()), 400);
    EXPECT_GT(std::fabs(bench.pan.angle()), 380);
  }
}

TEST(PanTiltNode, StopsWhatMovesWhenItEnds) {
  NodeBench bench;
  EXPECT_FALSE(bench.node.stop_moving(bench.now));
  bench.say(sweep_at(30));
  ASSERT_TRUE(bench.marked(sweep_mark_t::STARTED));
  EXPECT_TRUE(bench.node.stop_moving(bench.now));
  bench.run(0.05);
  EXPECT_FALSE(bench.pan.moving());
  EXPECT_EQ(bench.marks.back().mark, sweep_mark_t::ABORTED);
}

TEST(PanTiltNode, AClockThatIsSetBackStopsThePanAndNothingElse) {
  NodeBench bench;
  bench.say(sweep_at(30));
  ASSERT_TRUE(bench.marked(sweep_mark_t::STARTED));
  bench.run(1);
  bench.now -= 500'000'000;
  for (TestModule* module : {&bench.pan, &bench.tilt}) module->clock_was_set(bench.now);
  bench.run(0.1);
  EXPECT_FALSE(bench.pan.moving());
  EXPECT_EQ(bench.marks.back().mark, sweep_mark_t::ABORTED);
  EXPECT_EQ(bench.node.summary(bench.now), "");
  bench.say(sweep_at(30));
  EXPECT_TRUE(bench.marked(sweep_mark_t::ENDED));
  EXPECT_EQ(bench.counter("times_lost"), 0);
}

TEST(PanTiltNode, WhatSomebodyElseMovesIsNotMovedBeforeItStands) {
  NodeBench bench;
  // MOVE VEL 30 by another master.
  bench.receive(bench.pan.handle({0x50B, {0x05, 0xB5, 0x00, 0x00, 0xF0, 0x41}}, bench.now));
  bench.run(0.1);
  bench.say(sweep_at(30));
  EXPECT_NE(bench.node.summary(bench.now).find("pan is moving: stop it first"), std::string::npos);
  bench.say(command_of(Command::STOP));
  bench.run(0.1);
  bench.say(sweep_at(30));
  EXPECT_TRUE(bench.marked(sweep_mark_t::STARTED));
}

}  // namespace
}  // namespace scanway
