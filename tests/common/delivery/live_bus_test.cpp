// A node's end of the bus, turned by the test: what it repeats, refuses, counts and says on HEALTH.
#include "common/delivery/live_bus.h"

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <thread>
#include <vector>

#include "common/bus/channels.h"
#include "common/messages/codec.h"
#include "common/messages/goal_message.h"
#include "common/messages/imu_message.h"
#include "common/messages/objects.h"
#include "common/random/random.h"

namespace scanway {
namespace {

constexpr auto kNoWait = std::chrono::milliseconds(0);
constexpr Utime kStart = 1'700'000'000 * kMicrosecondsPerSecond;

class LiveBusTest : public testing::Test {
 protected:
  LiveBusTest() {
    lcm_.subscribe(channel::kHealth.name, [this](const BusMessage& message) {
      largest_health_ = std::max(largest_health_, message.bytes.size());
      const auto health = decode<health_t>(message.bytes);
      summary_[health.process_name] = health.summary;
      for (const counter_t& one : health.counters) counters_[health.process_name][one.counter_name] = one.count;
    });
  }
  static void turn(LiveBus& bus, double seconds) {
    for (const SteadyTime end = steady_now() + static_cast<SteadyTime>(seconds * 1e6); steady_now() < end;) {
      bus.turn(std::chrono::milliseconds(1));
      bus.dispatch(kNoWait);
    }
  }

  LcmBus lcm_{"memq://"};
  std::map<std::string, std::map<std::string, std::int64_t>> counters_;
  std::map<std::string, std::string> summary_;
  std::size_t largest_health_ = 0;
};

TEST_F(LiveBusTest, AGoalThatWasLostIsSaidAgain) {
  LiveBus operators(lcm_, this_process("operator"));
  operators.publish(channel::kGoal.name, encode(goal_message(kStart, {1, 2})), kStart);
  turn(operators, 0.1);  // Nobody has heard it.
  LiveBus planner(lcm_, this_process("planner"));
  std::vector<Eigen::Vector2d> goals;
  planner.subscribe(channel::kGoal.name,
                    [&](const BusMessage& goal) { goals.push_back(goal_of(decode<goal_t>(goal.bytes))); });
  for (int i = 0; i < 12; ++i) {
    turn(operators, 0.1);
    planner.dispatch(kNoWait);
  }
  ASSERT_FALSE(goals.empty());
  EXPECT_EQ(goals[0], Eigen::Vector2d(1, 2));
}

TEST_F(LiveBusTest, WhatIsMissingInAnEvenStreamIsCounted) {
  LiveBus mapper(lcm_, this_process("mapper"));
  int heard = 0;
  mapper.subscribe(channel::kImu.name, [&](const BusMessage&) { ++heard; });
  for (int i = 0; i < 200; ++i) {
    if (i == 60 || i == 100 || i == 101 || i == 130) continue;
    lcm_.publish(channel::kImu.name, encode(imu_message(kStart + 10'000 * i, Eigen::Quaterniond::Identity())), 0);
  }
  turn(mapper, 1.2);
  EXPECT_EQ(heard, 196);
  EXPECT_EQ(counters_["mapper"]["received_IMU"], 196);
  EXPECT_EQ(counters_["mapper"]["missing_IMU"], 4);
}

TEST_F(LiveBusTest, WhatIsRefusedIsCountedAndNamed) {
  LiveBus planner(lcm_, this_process("planner"));
  int heard = 0;
  planner.subscribe(channel::kGoal.name, [&](const BusMessage&) { ++heard; });
  lcm_.publish(channel::kGoal.name, std::vector<std::uint8_t>(40, 0x5A), 0);
  object_index_t index{};
  index.channel = channel::kCostMapTile.name;
  index.objects.resize(100);
  index.nobjects = 100;
  lcm_.publish(channel::kObjectIndex.name, encode(index), 0);  // Good, but larger than it may be.
  turn(planner, 1.2);
  EXPECT_EQ(heard, 0);
  EXPECT_EQ(counters_["planner"]["bad_messages"], 2);
  EXPECT_NE(summary_["planner"].find("refused 2 messages"), std::string::npos) << summary_["planner"];
}

TEST_F(LiveBusTest, WhatIsLackingIsGivenUpAndForgottenTogether) {
  LiveBusOptions options;
  options.receiver.give_up_after = 300'000;
  LiveBus mapper(lcm_, this_process("mapper"), options);
  ObjectAssembler node;
  int whole = 0;
  mapper.subscribe(channel::kSweep.name,
                   [&](const BusMessage& piece) { whole += node.add(decode<piece_t>(piece.bytes)) ? 1 : 0; });
  std::vector<std::uint8_t> object(5000);
  Random random(1);
  for (auto& byte : object) byte = static_cast<std::uint8_t>(random.next());
  const auto pieces = cut(object, "sweep", 1, kStart);
  ASSERT_GT(pieces.size(), 1U);
  lcm_.publish(channel::kSweep.name, encode(pieces[0]), 0);
  turn(mapper, 0.2);
  EXPECT_TRUE(mapper.lacks(channel::kSweep.name));
  turn(mapper, 0.5);
  EXPECT_FALSE(mapper.lacks(channel::kSweep.name));
  node.give_up_all();
  EXPECT_EQ(node.counters().given_up, 1U);
  for (const piece_t& piece : pieces) lcm_.publish(channel::kSweep.name, encode(piece), 0);
  turn(mapper, 1.2);
  EXPECT_EQ(whole, 1);
  EXPECT_EQ(counters_["mapper"]["given_up"], 1);
  EXPECT_EQ(counters_["mapper"]["lacking"], 0);
}

// For the thread sanitizer: both threads at work, and all that they share.
TEST(LiveBusThreads, TheNodesThreadAndTheBussOwnShareNothingUnguarded) {
  LcmBus lcm("memq://");
  LiveBus bus(lcm, this_process("node"));
  ObjectAssembler assembler;
  std::size_t whole = 0, told = 0;
  bus.subscribe(channel::kCloudTile.name,
                [&](const BusMessage& piece) { whole += assembler.add(decode<piece_t>(piece.bytes)) ? 1 : 0; });
  bus.subscribe(channel::kGoal.name, [&](const BusMessage&) { ++told; });
  bus.start();
  Random random(2);
  constexpr std::size_t kObjects = 40;
  for (std::size_t i = 0; i < kObjects; ++i) {
    std::vector<std::uint8_t> object(5000);
    for (auto& byte : object) byte = static_cast<std::uint8_t>(random.next());
    publish_object(bus, channel::kCloudTile, object, std::to_string(i), 1, kStart);
    bus.publish(channel::kGoal.name, encode(goal_message(kStart, {static_cast<double>(i), 0.0})), kStart);
    bus.report({{"objects", static_cast<std::int64_t>(i)}}, "busy");
    bus.dispatch(std::chrono::milliseconds(1));
    bus.lacks(channel::kCloudTile.name);
    bus.elder_twin();
  }
  bus.drain(std::chrono::seconds(5));
  for (const SteadyTime end = steady_now() + 10'000'000; whole < kObjects && steady_now() < end;) {
    bus.dispatch(std::chrono::milliseconds(20));
  }
  EXPECT_EQ(whole, kObjects);
  EXPECT_GE(told, kObjects);
}

TEST_F(LiveBusTest, HealthIsInFramesAndLosesNothingByThat) {
  LiveBus process(lcm_, this_process("busy"));
  std::map<std::string, std::int64_t> counters;
  for (int i = 0; i < 200; ++i) counters["a_counter_with_a_name_" + std::to_string(i)] = i;
  process.report(counters, std::string(5000, 's'));
  turn(process, 0.1);
  for (const auto& [name, count] : counters) EXPECT_EQ(counters_["busy"].at(name), count);
  EXPECT_LE(largest_health_, kMaxPieceBytes);
}

}  // namespace
}  // namespace scanway
