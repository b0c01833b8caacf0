// Lies of every kind on every channel that a process reads: refused, counted, for little memory, and the map is the
// right one afterwards. Built with the address and undefined-behaviour sanitizers (CMakeLists.txt).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "common/bus/memory_bus.h"
#include "common/messages/codec.h"
#include "common/messages/cost_map_message.h"
#include "common/messages/digest.h"
#include "common/messages/goal_message.h"
#include "common/messages/imu_message.h"
#include "common/messages/objects.h"
#include "common/messages/pose_message.h"
#include "common/messages/sweep_message.h"
#include "tests/common/messages/random_wire.h"
#include "tests/live/hostile/messages/hostile_messages.h"
#include "tests/live/hostile/processes.h"
#include "tests/modules/mapper/node/room.h"

// Leaks are looked for where a debugger may look (not in every container); they are not what this is about.
extern "C" const char* __asan_default_options() { return "detect_leaks=0"; }

namespace scanway::test {
namespace {

constexpr std::size_t kMegabyte = 1U << 20;
constexpr Utime kStart = 1'700'000'000 * kMicrosecondsPerSecond;

const std::vector<Channel> kOfMapper = {channel::kImu, channel::kSweep};
const std::vector<Channel> kOfPlanner = {channel::kPose, channel::kCostMapTile, channel::kCostMapIndex, channel::kGoal,
                                         channel::kMapState};
const std::vector<Channel> kOfBoth = {channel::kObjectIndex, channel::kPieceRequest, channel::kHealth};

std::vector<Channel> all_read() {
  std::vector<Channel> all = kOfMapper;
  all.insert(all.end(), kOfPlanner.begin(), kOfPlanner.end());
  all.insert(all.end(), kOfBoth.begin(), kOfBoth.end());
  return all;
}

bool is_of(const std::vector<Channel>& channels, const Channel& channel) {
  return std::any_of(channels.begin(), channels.end(), [&](const Channel& one) { return one.name == channel.name; });
}

template <class Publish>
void tell_the_truth(const Publish& publish) {
  publish(channel::kGoal.name, encode(goal_message(kStart - 10, {1.0, 0.5})));
  publish(channel::kImu.name, encode(imu_message(kStart - 5, Eigen::Quaterniond::Identity())));
  for (const piece_t& piece : cut(encode(to_message(room(kStart, "room"))), "room", 1, kStart)) {
    publish(channel::kSweep.name, encode(piece));
  }
}

class Hostile : public testing::Test {
 protected:
  void tell(const Channel& channel, const Bytes& bytes) {
    most_ = std::max(most_, processes_.tell(channel.name, bytes));
    ++told_;
  }
  void expect_the_right_map() {
    tell_the_truth([this](std::string_view channel, const Bytes& bytes) { processes_.tell(channel, bytes); });
    processes_.settle();
    MemoryBus bus;
    MapperNode mapper(bus, Robot{});
    PlannerNode planner(bus, Robot{});
    tell_the_truth([&](std::string_view channel, const Bytes& bytes) { bus.publish(channel, bytes, 0); });
    bus.dispatch();
    mapper.finish();
    bus.dispatch();
    planner.finish();
    ASSERT_EQ(mapper.state().map_version, 1);
    EXPECT_EQ(processes_.mapper().state().map_version, 1);
    EXPECT_EQ(processes_.mapper().state().map_digest, mapper.state().map_digest);
    EXPECT_TRUE(processes_.planner().map().tiles == planner.map().tiles);
    ASSERT_TRUE(planner.with_embodiment().has_value());
    ASSERT_TRUE(processes_.planner().with_embodiment().has_value());
    EXPECT_EQ(encode(*processes_.planner().with_embodiment()), encode(*planner.with_embodiment()));
  }

  Processes processes_;
  std::int64_t told_ = 0;
  std::size_t most_ = 0;  // Allocated by one of them.
};

TEST_F(Hostile, LiesAreRefusedAndCountedOneByOne) {
  Random random(1);
  std::int64_t of_mapper = 0, of_planner = 0;
  for (const Channel& channel : all_read()) {
    const Layout& layout = *find_layout(channel.cut ? std::string_view("scanway.piece_t") : channel.type);
    tell_lies(layout, random, 1, [&](const Bytes& bytes) {
      tell(channel, bytes);
      of_mapper += is_of(kOfPlanner, channel) ? 0 : 1;
      of_planner += is_of(kOfMapper, channel) ? 0 : 1;
    });
  }
  expect_the_right_map();
  EXPECT_EQ(processes_.health("mapper").at("bad_messages"), of_mapper);
  EXPECT_EQ(processes_.health("planner").at("bad_messages"), of_planner);
  EXPECT_LT(most_, kMegabyte);
  std::printf("%ld lies, the dearest allocated %zu kB\n", static_cast<long>(told_), most_ >> 10);
}

TEST_F(Hostile, LyingObjectsAreRefusedAndCountedOneByOne) {
  Random random(2);
  std::int64_t pieces_of_planner = 0;
  std::map<std::string_view, std::int64_t> objects;
  for (const Channel& channel : all_read()) {
    if (!channel.cut) continue;
    tell_lying_objects(channel, random, 3, [&](const piece_t& piece) {
      tell(channel, encode(piece));
      objects[channel.name] += piece.piece == 0 ? 1 : 0;
      pieces_of_planner += is_of(kOfPlanner, channel) ? 1 : 0;
    });
  }
  processes_.settle();
  EXPECT_EQ(processes_.health("mapper").at("mapper_bad_messages"), objects.at("SWEEP"));
  EXPECT_EQ(processes_.health("planner").at("planner_bad_messages"),
            objects.at("COST_MAP_TILE") + objects.at("COST_MAP_INDEX"));
  EXPECT_EQ(processes_.health("planner").at("pieces_received"), pieces_of_planner);
  expect_the_right_map();
  EXPECT_LT(most_, kMegabyte);
  std::printf("%ld pieces, the dearest allocated %zu kB\n", static_cast<long>(told_), most_ >> 10);
}

TEST_F(Hostile, ContradictionsBombsRequestsAndAnnouncementsChangeNothing) {
  Random random(3);
  for (const Channel& channel : all_read()) {
    if (channel.cut) tell_contradictions(random, 1000, [&](const piece_t& piece) { tell(channel, encode(piece)); });
  }
  for (int i = 0; i < 1000; ++i) {
    tell(channel::kPieceRequest, hostile_request(random));
    tell(channel::kObjectIndex, hostile_index(random));
  }
  expect_the_right_map();
  const auto& planner = processes_.health("planner");
  EXPECT_GT(planner.at("pieces_bad"), 500);
  EXPECT_GT(planner.at("objects_bad"), 10);
  EXPECT_EQ(planner.at("pieces_received"), planner.at("pieces_kept") + planner.at("pieces_repeated") +
                                               planner.at("pieces_superseded") + planner.at("pieces_bad"));
  EXPECT_LT(most_, kMegabyte);
  std::printf("%ld messages, the dearest allocated %zu kB\n", static_cast<long>(told_), most_ >> 10);
}

// Good messages whose values are absurd (not a number, beyond all numbers, of no time): they may be believed.
TEST_F(Hostile, AbsurdValuesEndNothing) {
  Random random(4);
  for (int i = 0; i < 300; ++i) {
    for (const Channel& channel : all_read()) {
      const Bytes bytes = random_wire(*find_layout(channel.type), random, 40);
      if (!channel.cut) {
        tell(channel, bytes);
      } else {
        for (const piece_t& piece : cut(bytes, "absurd", i, 0)) tell(channel, encode(piece));
      }
    }
  }
  processes_.settle();
  EXPECT_GT(processes_.health("planner").at("planner_bad_messages"), 0);
  EXPECT_LT(most_, 64 * kMegabyte);
  std::printf("%ld messages, the dearest allocated %zu kB\n", static_cast<long>(told_), most_ >> 10);
}

// A mapper that says where no map can be.
TEST_F(Hostile, AMapBeyondAllBoundsEndsNothing) {
  constexpr double kInf = std::numeric_limits<double>::infinity();
  constexpr std::int32_t kMost = std::numeric_limits<std::int32_t>::max(), kLeast = -kMost - 1;
  CostTile free;
  free.state.fill(CellState::free);
  free.cost.fill(0xFFFFFFFF);
  std::int64_t version = 0;
  const auto tell_map = [&](double resolution, double origin, const std::vector<Cell>& tiles) {
    CostMap map;
    map.resolution_m = resolution;
    map.origin_x_m = map.origin_y_m = origin;
    ++version;
    std::vector<cost_tile_entry_t> entries;
    for (const Cell& tile : tiles) {
      const Bytes bytes = encode(to_message(tile, free, version, kStart + version));
      entries.push_back({tile.x, tile.y, version, static_cast<std::int64_t>(digest(bytes))});
      for (const piece_t& piece : cut(bytes, tile_key(tile), version, 0)) tell(channel::kCostMapTile, encode(piece));
    }
    const Bytes index = encode(close_map(map, version, kStart + version, entries));
    for (const piece_t& piece : cut(index, "index", version, 0)) tell(channel::kCostMapIndex, encode(piece));
    tell(channel::kPose, encode(pose_message(kStart + version, Pose::Identity())));
    for (const double place : {0.5, 1e300, -1e9}) {
      tell(channel::kGoal, encode(goal_message(kStart + version, {place, place})));
    }
  };
  for (const double resolution : {0.01, 1e-300, 1e300, kInf, 0.0, -1.0}) {
    for (const double origin : {0.0, 1e300, kInf, std::nan("")}) tell_map(resolution, origin, {{0, 0}, {1, 0}});
  }
  tell_map(0.01, 0.0, {{kMost, kMost}, {kLeast, kLeast}, {0, 0}});
  tell_map(0.01, 0.0, {{-1'000'000, -1'000'000}, {1'000'000, 1'000'000}, {0, 0}});
  processes_.settle();
  EXPECT_NE(processes_.planner().summary().find("too large"), std::string::npos) << processes_.planner().summary();
  EXPECT_GT(processes_.health("planner").at("planner_bad_messages"), 15);
  EXPECT_LT(most_, 64 * kMegabyte);
  std::printf("%ld messages, the dearest allocated %zu kB\n", static_cast<long>(told_), most_ >> 10);
}

TEST_F(Hostile, ASweepBeyondAllBoundsEndsNothing) {
  Utime utime = kStart;
  for (const float absurd : {1e30F, std::numeric_limits<float>::infinity(), std::nanf("")}) {
    Sweep sweep = room(++utime, "room");
    for (std::size_t i = 0; i < sweep.cloud.size(); i += 3) sweep.cloud.points[i].x() = absurd;
    for (const piece_t& piece : cut(encode(to_message(sweep)), "absurd", utime, utime)) {
      tell(channel::kSweep, encode(piece));
    }
  }
  processes_.settle();
  EXPECT_EQ(processes_.health("mapper").at("lacking"), 0);
}

}  // namespace
}  // namespace scanway::test
