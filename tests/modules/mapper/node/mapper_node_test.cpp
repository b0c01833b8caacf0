// When the mapper's node closes a sweep, what it says of it, and what it keeps over a restart. Its maps are tested with
// the core.
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "common/bus/channels.h"
#include "common/bus/memory_bus.h"
#include "common/files/input_error.h"
#include "common/messages/codec.h"
#include "common/messages/digest.h"
#include "common/messages/imu_message.h"
#include "common/messages/objects.h"
#include "common/messages/sweep_message.h"
#include "common/random/random.h"
#include "modules/mapper/node/arrival_keeper.h"
#include "modules/mapper/node/mapper_node.h"
#include "modules/mapper/node/sweep_store.h"
#include "scanway/registration_t.hpp"
#include "tests/modules/mapper/node/room.h"
#include "tests/support/command.h"

namespace scanway {
namespace {

using test::room;

constexpr Utime kStart = 1'700'000'000 * kMicrosecondsPerSecond;

class MapperNodeTest : public testing::Test {
 protected:
  MapperNodeTest() { watch(bus_); }

  void watch(MemoryBus& bus) {
    bus.subscribe(channel::kSweepInputs.name,
                  [this](const BusMessage& message) { inputs_.push_back(decode<sweep_inputs_t>(message.bytes)); });
    bus.subscribe(channel::kCostMapIndex.name, [this](const BusMessage& message) {
      const auto piece = decode<piece_t>(message.bytes);
      versions_[piece.version] = piece.digest;
    });
  }
  void send_imu(Bus& bus, Utime utime) {
    bus.publish(channel::kImu.name, encode(imu_message(utime, Eigen::Quaterniond::Identity())), utime);
  }
  void send_sweep(Bus& bus, Utime utime, const std::string& name) {
    publish_object(bus, channel::kSweep, encode(to_message(room(utime, name))), name, ++sent_, utime);
  }

  MemoryBus bus_;
  std::vector<sweep_inputs_t> inputs_;
  std::map<std::int64_t, std::int64_t> versions_;  // Digest of each version's index, as an object.
  std::int64_t sent_ = 0;
};

TEST_F(MapperNodeTest, ASweepWaitsForTheOrientationThatFollowsIt) {
  MapperNode node(bus_, Robot{});
  send_imu(bus_, kStart - 10'000);
  send_sweep(bus_, kStart, "a");
  bus_.dispatch();
  EXPECT_TRUE(inputs_.empty());
  EXPECT_FALSE(node.state().settled);
  send_imu(bus_, kStart + 10'000);
  bus_.dispatch();
  ASSERT_EQ(inputs_.size(), 1U);
  EXPECT_EQ(inputs_[0].inputs[0].last_utime, kStart - 10'000);
  EXPECT_EQ(node.state().map_version, 1);
}

TEST_F(MapperNodeTest, InSilenceASweepIsClosedAsAtTheEndOfALog) {
  MapperNode node(bus_, Robot{});
  send_imu(bus_, kStart - 10'000);
  send_sweep(bus_, kStart, "a");
  bus_.dispatch();
  node.settle();
  bus_.dispatch();
  ASSERT_EQ(inputs_.size(), 1U);
  EXPECT_EQ(inputs_[0].inputs[0].used_count, 1);
  EXPECT_TRUE(node.state().settled);
  const auto live = versions_;

  MemoryBus replay_bus;
  versions_.clear();
  watch(replay_bus);
  MapperNode replayed(replay_bus, Robot{});
  sent_ = 0;
  send_imu(replay_bus, kStart - 10'000);
  send_sweep(replay_bus, kStart, "a");
  replay_bus.dispatch();
  replayed.finish();
  replay_bus.dispatch();
  EXPECT_EQ(versions_, live);
}

TEST_F(MapperNodeTest, ASweepThatNeverBecomesWholeIsGivenUpOnceNobodyAsksForItAnyMore) {
  MapperNode node(bus_, Robot{});
  send_sweep(bus_, kStart, "a");
  const auto lacking = cut(encode(to_message(room(kStart + 1, "b"))), "b", 1, kStart + 1);
  bus_.publish(channel::kSweep.name, encode(lacking[0]), 0);
  bus_.dispatch();
  node.settle(true);
  EXPECT_FALSE(node.state().settled);
  EXPECT_EQ(node.counters().at("mapper_incomplete_sweeps"), 1);
  node.settle(false);
  EXPECT_TRUE(node.state().settled);
  EXPECT_EQ(node.state().map_version, 1);
  EXPECT_EQ(node.counters().at("mapper_given_up_sweeps"), 1);
  EXPECT_NE(node.summary().find("1 sweeps never became whole"), std::string::npos) << node.summary();
}

TEST_F(MapperNodeTest, WithoutATrackerASweepIsClosedAndThatIsSaid) {
  MapperNode node(bus_, Robot{});
  send_sweep(bus_, kStart, "a");
  bus_.dispatch();
  node.settle();
  bus_.dispatch();
  ASSERT_EQ(inputs_.size(), 1U);
  EXPECT_EQ(inputs_[0].inputs[0].used_count, 0);
  EXPECT_EQ(node.counters().at("mapper_sweeps_without_orientation"), 1);
  EXPECT_NE(node.summary().find("no orientation"), std::string::npos);
}

TEST_F(MapperNodeTest, ARefusedSweepIsCountedAndItsReasonSaid) {
  MapperNode node(bus_, Robot{});
  send_sweep(bus_, kStart, "a");
  Sweep elsewhere = room(kStart + 20'000'000, "b");
  Random random(2);
  for (Eigen::Vector3f& p : elsewhere.cloud.points) p *= static_cast<float>(1.0 + 3.0 * random.uniform());
  publish_object(bus_, channel::kSweep, encode(to_message(elsewhere)), "b", ++sent_, elsewhere.utime);
  bus_.dispatch();
  node.finish();
  EXPECT_EQ(node.state().map_version, 1);
  EXPECT_EQ(node.counters().at("mapper_sweeps_refused"), 1);
  EXPECT_NE(node.summary().find("b was refused: "), std::string::npos) << node.summary();
}

TEST_F(MapperNodeTest, AListedSweepGetsTheOrientationThatItHadWhateverCame) {
  const auto imu = encode(imu_message(kStart - 20'000, Eigen::Quaterniond::Identity()));
  const auto digest_of_sweep = [](Utime utime, const std::string& name) {
    return digest(encode(to_message(room(utime, name))));
  };
  MapperNode node(bus_, Robot{});
  node.use({{digest_of_sweep(kStart, "a"), digest(imu)}, {digest_of_sweep(kStart + 5'000'000, "b"), std::nullopt}});
  send_imu(bus_, kStart - 20'000);
  send_imu(bus_, kStart - 10'000);  // Newer, but not the one that was used.
  send_sweep(bus_, kStart, "a");
  send_imu(bus_, kStart + 4'990'000);  // Came too late to be used.
  send_sweep(bus_, kStart + 5'000'000, "b");
  bus_.dispatch();
  node.finish();
  bus_.dispatch();
  ASSERT_EQ(inputs_.size(), 2U);
  EXPECT_EQ(inputs_[0].inputs[0].last_utime, kStart - 20'000);
  EXPECT_EQ(inputs_[1].inputs[0].used_count, 0);
}

TEST_F(MapperNodeTest, EachSweepIsFinishedOnceItsProductsAreOut) {
  MapperNode node(bus_, Robot{});
  std::vector<std::string> finished;
  node.on_finished([&](std::string_view name, Utime) { finished.emplace_back(name); });
  send_sweep(bus_, kStart, "a");
  bus_.dispatch();
  EXPECT_TRUE(finished.empty());
  node.settle();
  EXPECT_EQ(finished, std::vector<std::string>{"a"});
}

TEST_F(MapperNodeTest, ANodeThatIsStartedAgainHasTheSameMap) {
  const test::ScratchFolder scratch;
  const SweepStore store(scratch / "state");
  ArrivalKeeper keeper(store);
  for (const Channel& input : {channel::kImu, channel::kSweep}) {
    bus_.subscribe(input.name, [&keeper](const BusMessage& message) { keeper.take(message); });
  }
  MapperNode node(bus_, Robot{});
  node.restore(store);
  send_imu(bus_, kStart - 10'000);
  send_sweep(bus_, kStart, "a");
  send_imu(bus_, kStart + 10'000);
  send_sweep(bus_, kStart + 20'000'000, "b");  // Has no orientation, and waits for one.
  bus_.dispatch();
  EXPECT_EQ(versions_.size(), 1U);
  EXPECT_EQ(store.logs().size(), 2U);

  MemoryBus bus;
  MapperNode again(bus, Robot{});
  watch(bus);
  const auto inputs_before = std::exchange(inputs_, {});
  const auto before = std::exchange(versions_, {});
  again.restore(store);
  bus.dispatch();
  ASSERT_EQ(inputs_.size(), 2U);
  EXPECT_EQ(inputs_[0].sweep_digest, inputs_before[0].sweep_digest);
  EXPECT_EQ(inputs_[0].inputs[0].used_digest, inputs_before[0].inputs[0].used_digest);
  EXPECT_EQ(versions_.at(1), before.at(1));
  node.settle();
  bus_.dispatch();
  EXPECT_EQ(again.state().map_version, node.state().map_version);
  EXPECT_EQ(again.state().map_digest, node.state().map_digest);
  const auto known = versions_;
  send_sweep(bus, kStart, "a");  // Sent once more: it is known.
  bus.dispatch();
  again.settle();
  bus.dispatch();
  EXPECT_EQ(versions_, known);
}

/// A folder with the kept sweep of a map, whose digest is returned.
std::int64_t keep_a_map(const std::string& folder) {
  MemoryBus bus;
  const SweepStore store(folder);
  MapperNode node(bus, Robot{});
  node.keep_in(store);
  publish_object(bus, channel::kSweep, encode(to_message(room(kStart, "a"))), "a", 1, kStart);
  bus.dispatch();
  node.finish();
  return node.state().map_digest;
}

TEST_F(MapperNodeTest, AMapThatIsContinuedIsPublishedOnceAndWhole) {
  const test::ScratchFolder scratch;
  const std::int64_t kept = keep_a_map(scratch / "first");
  std::size_t verdicts = 0, tiles = 0;
  bus_.subscribe(channel::kRegistration.name, [&verdicts](const BusMessage&) { ++verdicts; });
  bus_.subscribe(channel::kCostMapTile.name, [&tiles](const BusMessage&) { ++tiles; });
  MapperNode node(bus_, Robot{});
  node.resume(saved_map(scratch / "first"));
  bus_.dispatch();
  EXPECT_EQ(node.state().map_digest, kept);
  EXPECT_EQ(node.state().map_version, 1);
  EXPECT_EQ(versions_.size(), 1U);
  EXPECT_TRUE(inputs_.empty()) << "its sweeps are those of another session";
  EXPECT_EQ(verdicts, 0U);
  EXPECT_GE(tiles, node.mapper().map().cost_map().tiles.size());

  send_sweep(bus_, kStart - 1'000'000'000, "b");  // Before all of that map's: another session has its own time.
  bus_.dispatch();
  node.finish();
  bus_.dispatch();
  EXPECT_EQ(inputs_.size(), 1U);
  EXPECT_EQ(verdicts, 1U);
  EXPECT_EQ(node.counters().at("mapper_late_sweeps"), 0);
}

TEST_F(MapperNodeTest, AFolderTakesOverTheMapThatItContinues) {
  const test::ScratchFolder scratch;
  const std::int64_t kept = keep_a_map(scratch / "first");
  const SweepStore second(scratch / "second");
  second.continue_from(scratch / "first");
  second.continue_from(scratch / "first");  // Once is enough.
  std::filesystem::remove_all(scratch / "first");
  EXPECT_TRUE(second.logs().empty());
  MapperNode node(bus_, Robot{});
  node.restore(second);
  EXPECT_EQ(node.state().map_digest, kept);
  const SweepStore third(scratch / "third");
  third.continue_from(scratch / "second");
  MemoryBus bus;
  MapperNode again(bus, Robot{});
  again.restore(third);
  EXPECT_EQ(again.state().map_digest, kept);
}

TEST_F(MapperNodeTest, AFolderWithoutAMapCannotBeContinued) {
  const test::ScratchFolder scratch;
  std::filesystem::create_directory(scratch / "empty");
  for (const char* name : {"empty", "not-there"}) {
    try {
      saved_map(scratch / name);
      FAIL() << name;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("holds no sweeps of a map"), std::string::npos) << error.what();
    }
  }
  EXPECT_FALSE(std::filesystem::exists(scratch / "not-there"));
}

TEST_F(MapperNodeTest, AStateThatIsDamagedIsSaid) {
  const test::ScratchFolder scratch;
  const SweepStore store(scratch / "state");
  {
    MapperNode node(bus_, Robot{});
    node.restore(store);
    send_sweep(bus_, kStart, "a");
    bus_.dispatch();
    node.settle();
  }
  const std::string log = store.logs().at(0);
  std::filesystem::resize_file(log, std::filesystem::file_size(log) / 2);
  MemoryBus bus;
  MapperNode again(bus, Robot{});
  again.restore(store);
  EXPECT_EQ(again.state().map_version, 0);
  EXPECT_NE(again.summary().find("cut off"), std::string::npos) << again.summary();
}

}  // namespace
}  // namespace scanway
