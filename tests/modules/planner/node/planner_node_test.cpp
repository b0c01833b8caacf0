// When the planner's node closes a plan, and what it does until then. Its paths are tested with the core.
#include <gtest/gtest.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "common/bus/channels.h"
#include "common/bus/memory_bus.h"
#include "common/messages/codec.h"
#include "common/messages/cost_map_message.h"
#include "common/messages/digest.h"
#include "common/messages/goal_message.h"
#include "common/messages/objects.h"
#include "common/messages/pose_message.h"
#include "modules/planner/node/planner_node.h"

namespace scanway {
namespace {

constexpr Utime kSecond = kMicrosecondsPerSecond;
constexpr Utime kStart = 1'700'000'000 * kSecond;

/// Floor without an obstacle, 4 x 4 tiles of 1.28 m, the robot in its middle; one tile more with each version.
CostMap floor_of(std::int64_t version) {
  CostMap map;
  map.resolution_m = 0.01;
  map.origin_x_m = map.origin_y_m = -2.56;
  CostTile free;
  free.state.fill(CellState::free);
  free.cost.fill(0);
  for (std::int32_t x = 0; x < 4; ++x) {
    for (std::int32_t y = 0; y < 4; ++y) map.tiles[{x, y}] = free;
  }
  for (std::int32_t more = 1; more < version; ++more) map.tiles[{4, more - 1}] = free;
  return map;
}

class PlannerNodeTest : public testing::Test {
 protected:
  struct Heard {
    std::string key;
    path_t path;
    std::uint64_t digest = 0;
  };

  PlannerNodeTest() {
    bus_.subscribe(channel::kPath.name, [this](const BusMessage& message) {
      const auto object = paths_in_.add(decode<piece_t>(message.bytes));
      if (object) heard_.push_back({object->key, decode<path_t>(object->bytes), object->digest});
    });
  }

  void send_goal(Utime utime, double x) {
    bus_.publish(channel::kGoal.name, encode(goal_message(utime, {x, 0.0})), utime);
  }
  void send_pose(Utime utime) {
    bus_.publish(channel::kPose.name, encode(pose_message(utime, Pose::Identity())), utime);
  }
  /// Without the tile (0, 0) if `hole`.
  void send_version(std::int64_t version, Utime utime, bool hole = false) {
    const CostMap map = floor_of(version);
    std::vector<cost_tile_entry_t> entries;
    for (const auto& [tile, cells] : map.tiles) {
      const auto bytes = encode(to_message(tile, cells, version, utime));
      entries.push_back({tile.x, tile.y, version, static_cast<std::int64_t>(digest(bytes))});
      if (hole && tile == Cell{0, 0}) continue;
      publish_object(bus_, channel::kCostMapTile, bytes, tile_key(tile), version, utime);
    }
    const auto index = encode(close_map(map, version, utime, entries));
    publish_object(bus_, channel::kCostMapIndex, index, kCostMapIndexKey, version, utime);
  }
  void send_state(std::int64_t version, bool settled) {
    map_state_t state{};
    state.map_version = version;
    state.settled = settled;
    bus_.publish(channel::kMapState.name, encode(state), 0);
  }

  std::vector<Heard> of(bool provisional) const {
    std::vector<Heard> some;
    for (const Heard& heard : heard_) {
      if ((heard.path.provisional != 0) == provisional) some.push_back(heard);
    }
    return some;
  }

  MemoryBus bus_;
  ObjectAssembler paths_in_;
  std::vector<Heard> heard_;
};

TEST_F(PlannerNodeTest, AGoalIsAnsweredAtOnceAndClosedWhenTheMapperIsSettled) {
  PlannerNode node(bus_, Robot{}, nullptr, PlannerNode::Pace::live);
  send_pose(kStart);
  send_version(1, kStart);
  bus_.dispatch();
  EXPECT_TRUE(heard_.empty());
  send_goal(kStart + 5 * kSecond, 1.0);
  bus_.dispatch();
  ASSERT_EQ(of(true).size(), 2U);  // A mode each.
  EXPECT_TRUE(of(false).empty());
  EXPECT_EQ(of(true)[0].path.status, "ok");
  EXPECT_TRUE(of(true)[0].path.map_up_to_date);

  node.settle();  // The mapper has said nothing.
  send_state(1, false);
  bus_.dispatch();
  node.settle();  // It works on something.
  bus_.dispatch();
  EXPECT_TRUE(of(false).empty());
  send_state(1, true);
  bus_.dispatch();
  node.settle();
  bus_.dispatch();
  ASSERT_EQ(of(false).size(), 2U);
  EXPECT_EQ(of(false)[0].path.pose_x_m, of(true)[0].path.pose_x_m);
}

TEST_F(PlannerNodeTest, WithinItsPaceOfDataTimeNothingIsProvisional) {
  PlannerNode node(bus_, Robot{});
  send_goal(kStart - kSecond, 1.0);
  send_pose(kStart);
  send_version(1, kStart);
  bus_.dispatch();
  EXPECT_TRUE(heard_.empty());
  node.finish();
  bus_.dispatch();
  EXPECT_EQ(of(false).size(), 2U);
  EXPECT_TRUE(of(true).empty());
}

TEST_F(PlannerNodeTest, LiveAndReplayCloseTheSamePlans) {
  const auto play = [this](PlannerNode& node, bool silences) {
    const auto silence = [&](std::int64_t version) {
      bus_.dispatch();
      if (!silences) return;
      send_state(version, true);
      bus_.dispatch();
      node.settle();
    };
    send_goal(kStart - kSecond, 1.0);
    send_pose(kStart);
    send_version(1, kStart);
    silence(1);
    send_goal(kStart + 10 * kSecond, -1.0);
    silence(1);
    send_pose(kStart + 20 * kSecond);
    send_version(2, kStart + 20 * kSecond);
    silence(2);
    node.finish();
    bus_.dispatch();
  };
  std::map<std::pair<std::string, std::int64_t>, std::uint64_t> closed[2];
  for (const bool live : {true, false}) {
    MemoryBus fresh;
    heard_.clear();
    std::swap(bus_, fresh);
    paths_in_ = ObjectAssembler();
    bus_.subscribe(channel::kPath.name, [this](const BusMessage& message) {
      const auto object = paths_in_.add(decode<piece_t>(message.bytes));
      if (object) heard_.push_back({object->key, decode<path_t>(object->bytes), object->digest});
    });
    PlannerNode node(bus_, Robot{}, nullptr, live ? PlannerNode::Pace::live : PlannerNode::Pace::data_time);
    play(node, live);
    for (const Heard& heard : of(false)) closed[live ? 1 : 0][{heard.key, heard.path.utime}] = heard.digest;
  }
  EXPECT_EQ(closed[0].size(), 6U);
  EXPECT_EQ(closed[0], closed[1]);
}

TEST_F(PlannerNodeTest, WhileTilesAreMissingItPlansOnWhatItHasAndSaysSo) {
  PlannerNode node(bus_, Robot{}, nullptr, PlannerNode::Pace::live);
  send_pose(kStart);
  send_version(1, kStart);
  send_version(2, kStart + 10 * kSecond, true);
  send_goal(kStart + 11 * kSecond, 1.0);
  bus_.dispatch();
  ASSERT_EQ(of(true).size(), 2U);
  EXPECT_EQ(of(true)[0].path.map_version, 1);
  EXPECT_FALSE(of(true)[0].path.map_up_to_date);
  EXPECT_EQ(node.counters().at("planner_map_behind"), 1);
  EXPECT_FALSE(node.summary().empty());
  send_state(2, true);
  bus_.dispatch();
  node.settle();
  bus_.dispatch();
  EXPECT_TRUE(of(false).empty());
}

TEST_F(PlannerNodeTest, WhatIsLateIsCountedAndCountsAllTheSame) {
  PlannerNode node(bus_, Robot{}, nullptr, PlannerNode::Pace::live);
  send_pose(kStart);
  send_version(1, kStart);
  send_goal(kStart + 300 * kSecond, 1.0);
  send_pose(kStart + 600 * kSecond);  // Now all of the above is past.
  bus_.dispatch();
  heard_.clear();
  send_version(2, kStart + 100 * kSecond);
  bus_.dispatch();
  EXPECT_EQ(node.counters().at("planner_late_maps"), 1);
  ASSERT_EQ(of(false).size(), 2U);
  EXPECT_EQ(of(false)[0].path.map_version, 2);
  EXPECT_EQ(node.map().tiles.size(), floor_of(2).tiles.size());
}

TEST_F(PlannerNodeTest, ARepeatedPoseOrGoalIsNoNews) {
  PlannerNode node(bus_, Robot{}, nullptr, PlannerNode::Pace::live);
  send_pose(kStart);
  bus_.dispatch();
  const std::size_t news = node.news();
  send_pose(kStart);
  bus_.dispatch();
  EXPECT_EQ(node.news(), news);
  send_goal(kStart, 1.0);
  send_goal(kStart, 1.0);
  bus_.dispatch();
  EXPECT_EQ(node.news(), news + 1);
  EXPECT_EQ(node.counters().at("planner_late_poses"), 0);
}

TEST_F(PlannerNodeTest, SeesThatTheMapperHasBegunAnotherMap) {
  PlannerNode node(bus_, Robot{}, nullptr, PlannerNode::Pace::live);
  send_version(1, kStart);
  send_version(2, kStart + kSecond);
  send_state(2, true);
  bus_.dispatch();
  EXPECT_FALSE(node.outdated());
  send_state(1, true);
  bus_.dispatch();
  EXPECT_TRUE(node.outdated());
}

}  // namespace
}  // namespace scanway
