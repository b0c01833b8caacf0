// The base's node on a bus in memory, with a test robot on a wire in memory and a clock of its own.

#include "modules/base_bridge/node/base_node.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "bot_core/pose_t.hpp"
#include "common/bus/channels.h"
#include "common/bus/memory_bus.h"
#include "common/messages/codec.h"
#include "tests/modules/base_bridge/test_robot.h"

namespace scanway {
namespace {

struct Bench {
  Bench() {
    bus.subscribe(channel::kOdometry.name,
                  [this](const BusMessage& message) { poses.push_back(decode<bot_core::pose_t>(message.bytes)); });
  }
  void run(double seconds) {
    for (const Utime end = now + static_cast<Utime>(seconds * 1e6); now < end; now += 5'000) {
      bus.dispatch();
      node.obey(now);
      base.receive(robot.run(now), now);
      base.tick(now);
      for (auto packet = base.next_packet(now); !packet.empty(); packet = base.next_packet(now)) {
        base.receive(robot.receive(packet, base.baud()), now);
      }
      node.tell();
    }
    bus.dispatch();
  }
  void command(double speed, double turn_rate) {
    base_command_t message{};
    message.forward_speed_m_s = speed;
    message.turn_rate_rad_s = turn_rate;
    bus.publish(channel::kBaseCommand.name, encode(message), now);
  }
  void drive(double speed, double turn_rate, double seconds) {
    for (double gone = 0; gone < seconds - 1e-9; gone += 0.1) {
      command(speed, turn_rate);
      run(0.1);
    }
  }

  Utime now = 1'000'000'000;
  MemoryBus bus;
  test::TestRobot robot;
  erratic::Base base;
  erratic::BaseNode node{bus, base};
  std::vector<bot_core::pose_t> poses;
};

TEST(BaseNode, PublishesWhereTheRobotIsInTheFrameWhereItWasSwitchedOn) {
  Bench bench;
  bench.run(0.5);
  ASSERT_FALSE(bench.poses.empty());
  EXPECT_EQ(bench.poses.back().pos[0], 0);
  bench.drive(0.5, 0, 10);  // 5 m: past the wrap of the robot's counters, 3.8 m.
  EXPECT_NEAR(bench.poses.back().pos[0], bench.robot.x_mm / 1000, 0.002);
  EXPECT_GT(bench.poses.back().pos[0], 4.5);
  EXPECT_NEAR(bench.poses.back().vel[0], 0.5, 0.001);
  bench.drive(0, radians(45), 2);
  EXPECT_NEAR(2 * std::atan2(bench.poses.back().orientation[3], bench.poses.back().orientation[0]), bench.robot.heading,
              0.002);
  EXPECT_GT(bench.robot.heading, 1.2);
  for (std::size_t i = 1; i < bench.poses.size(); ++i) {
    ASSERT_EQ(bench.poses[i].utime - bench.poses[i - 1].utime, bench.robot.report_period) << i;
  }
}

TEST(BaseNode, ACommandRunsOut) {
  Bench bench;
  bench.run(0.5);
  bench.drive(0.4, 0.3, 0.5);
  ASSERT_EQ(bench.robot.speed_mm_s, 400);
  ASSERT_TRUE(bench.robot.motors_on);
  bench.run(0.1);  // The last command is 0.2 s old.
  EXPECT_EQ(bench.robot.speed_mm_s, 0);
  bench.run(0.1);
  EXPECT_EQ(bench.robot.turn_deg_s, 0);
  EXPECT_FALSE(bench.robot.motors_on);
  EXPECT_EQ(bench.node.counters().at("base_commands_ran_out"), 1);
  EXPECT_EQ(bench.node.summary(bench.now), "");
}

TEST(BaseNode, AClockThatIsSetBackStopsTheRobot) {
  Bench bench;
  bench.run(0.5);
  bench.drive(0.4, 0.3, 0.5);
  ASSERT_EQ(bench.robot.speed_mm_s, 400);
  bench.now -= 500'000'000;
  bench.robot.report_now(bench.now);
  bench.run(0.1);
  EXPECT_EQ(bench.robot.speed_mm_s, 0);
  EXPECT_EQ(bench.robot.turn_deg_s, 0);
  EXPECT_FALSE(bench.robot.motors_on);
  bench.drive(0.4, 0.3, 0.5);
  EXPECT_EQ(bench.robot.speed_mm_s, 400);
  bench.run(0.3);
  EXPECT_FALSE(bench.robot.motors_on);
}

TEST(BaseNode, OnlyTheNewestCommandCounts) {
  Bench bench;
  bench.run(0.5);
  for (const double speed : {0.9, 0.5, 0.1}) bench.command(speed, 0);
  bench.run(0.1);
  EXPECT_EQ(bench.robot.speed_mm_s, 100);
  EXPECT_EQ(bench.node.counters().at("base_commands"), 3);
}

TEST(BaseNode, RefusesWhatIsNoCommandAndSaysSo) {
  Bench bench;
  bench.robot.powered = false;
  bench.run(0.5);
  EXPECT_EQ(bench.node.summary(bench.now), "the base does not answer");
  bench.command(0.1, 0);
  bench.run(0.1);
  EXPECT_EQ(bench.node.counters().at("base_commands_refused"), 1);
  bench.robot.powered = true;
  bench.run(3);
  bench.drive(0.4, 0, 0.3);
  ASSERT_EQ(bench.robot.speed_mm_s, 400);
  bench.command(std::numeric_limits<double>::quiet_NaN(), 0);
  bench.run(0.1);
  EXPECT_EQ(bench.robot.speed_mm_s, 0);
  EXPECT_NE(bench.node.summary(bench.now).find("no number"), std::string::npos);
  bench.bus.publish(channel::kBaseCommand.name, std::vector<std::uint8_t>{1, 2, 3}, bench.now);
  bench.run(11);
  EXPECT_EQ(bench.node.counters().at("base_bad_messages"), 1);
  EXPECT_EQ(bench.node.summary(bench.now), "");
  bench.robot.stalled = true;
  bench.run(0.2);
  EXPECT_EQ(bench.node.counters().at("base_stalls"), 1);
  EXPECT_EQ(bench.node.summary(bench.now), "a wheel is stalled");
}

}  // namespace
}  // namespace scanway
