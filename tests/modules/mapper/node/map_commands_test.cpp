// A sweep is withdrawn by a command on the bus, live, in replay and over a restart.
#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "common/bus/channels.h"
#include "common/bus/memory_bus.h"
#include "common/files/input_error.h"
#include "common/messages/codec.h"
#include "common/messages/imu_message.h"
#include "common/messages/objects.h"
#include "common/messages/sweep_message.h"
#include "common/random/random.h"
#include "modules/mapper/node/mapper_node.h"
#include "modules/mapper/node/sweep_store.h"
#include "tests/support/command.h"

namespace scanway {
namespace {

constexpr Utime kFirst = 1'700'000'000 * kMicrosecondsPerSecond;
constexpr Utime kApart = 60 * kMicrosecondsPerSecond;
constexpr Utime kGiven = kFirst + 3600 * kMicrosecondsPerSecond;  // of the operator's clock

/// A workshop of 8 m x 6 m with two cupboards, seen from a sensor 1 m above the floor.
Sweep workshop(int number) {
  Random random(static_cast<std::uint64_t>(number) + 1);
  Sweep sweep;
  sweep.name = "sweep " + std::to_string(number);
  sweep.utime = kFirst + number * kApart;
  const auto add = [&](double x, double y, double z) {
    sweep.cloud.points.push_back(Eigen::Vector3d(x, y, z).cast<float>());
  };
  for (int i = 0; i < 5000; ++i) {
    const double u = 8.0 * random.uniform() - 4.0, v = 6.0 * random.uniform() - 3.0, h = 2.5 * random.uniform() - 1.0;
    add(u, v, -1.0);
    add(u, random.uniform() < 0.5 ? -3.0 : 3.0, h);
    add(random.uniform() < 0.5 ? -4.0 : 4.0, v, h);
    if (i % 2 == 0) continue;
    add(1.5, 1.0 + random.uniform(), h);
    add(1.5 + random.uniform(), 1.0, h);
    add(-2.5 + 0.6 * random.uniform(), -1.2, h);
  }
  return sweep;
}

/// A mapper on a bus of its own, and what it answers.
class Bench {
 public:
  Bench() : node_(bus_, Robot{}) {
    bus_.subscribe(channel::kMapAnswer.name,
                   [this](const BusMessage& message) { answers.push_back(decode<map_answer_t>(message.bytes)); });
  }
  void send_sweep(int number) {
    const Sweep sweep = workshop(number);
    const auto imu = imu_message(sweep.utime, Eigen::Quaterniond::Identity());
    bus_.publish(channel::kImu.name, encode(imu), sweep.utime);
    publish_object(bus_, channel::kSweep, encode(to_message(sweep)), sweep.name, number, sweep.utime);
    bus_.dispatch();
    node_.settle();
    bus_.dispatch();
  }
  void withdraw(const std::string& name, Utime given = kGiven) { order(map_command_t::WITHDRAW, name, given); }
  void order(std::int8_t what, const std::string& name, Utime given) {
    map_command_t command{};
    command.utime = given;
    command.command = what;
    command.sweep_name = name;
    bus_.publish(channel::kMapCommand.name, encode(command), given);
    bus_.dispatch();
  }
  const std::map<Cell, CostTile>& tiles() const { return node_.mapper().map().cost_map().tiles; }
  std::string octomap() const { return node_.mapper().map().occupancy_tree().ot_bytes(); }
  map_state_t state() const { return node_.state(); }
  MapperNode& node() { return node_; }

  std::vector<map_answer_t> answers;

 private:
  MemoryBus bus_;
  MapperNode node_;
};

TEST(MapCommands, AWithdrawnSweepIsGoneAndThatIsAnsweredOnce) {
  Bench bench;
  bench.send_sweep(0);
  const auto tiles = bench.tiles();
  const std::string octomap = bench.octomap();
  bench.send_sweep(1);
  ASSERT_EQ(bench.state().map_version, 2);
  ASSERT_FALSE(bench.octomap() == octomap);
  for (int said = 0; said < 3; ++said) bench.withdraw("sweep 1");
  ASSERT_EQ(bench.answers.size(), 1u);
  EXPECT_TRUE(bench.answers[0].done) << bench.answers[0].reason;
  EXPECT_EQ(bench.answers[0].map_version, 3);
  EXPECT_EQ(bench.state().map_version, 3);
  EXPECT_TRUE(bench.tiles() == tiles);
  EXPECT_TRUE(bench.octomap() == octomap);

  bench.withdraw("sweep 1", kGiven + 1);
  bench.withdraw("sweep 7", kGiven + 2);
  ASSERT_EQ(bench.answers.size(), 3u);
  for (const std::size_t refused : {1u, 2u}) {
    EXPECT_FALSE(bench.answers[refused].done);
    EXPECT_EQ(bench.answers[refused].reason, "The map holds no sweep of that name.");
    EXPECT_EQ(bench.answers[refused].map_version, 3);
  }
  bench.send_sweep(2);
  EXPECT_EQ(bench.state().map_version, 4);
}

TEST(MapCommands, TheMapIsSavedOnceAndItIsSaidWhyNot) {
  Bench bench;
  bench.send_sweep(0);
  bench.order(map_command_t::SAVE, "nobody", kGiven);  // As in replay: nobody saves, nobody answers.
  EXPECT_TRUE(bench.answers.empty());
  std::vector<std::string> saved;
  bench.node().on_save([&saved](const std::string& name) {
    if (name == "full") throw InputError("the disk is full");
    saved.push_back(name);
  });
  for (int said = 0; said < 3; ++said) bench.order(map_command_t::SAVE, "monday", kGiven + 1);
  bench.order(map_command_t::SAVE, "full", kGiven + 2);
  EXPECT_EQ(saved, std::vector<std::string>{"monday"});
  ASSERT_EQ(bench.answers.size(), 2u);
  EXPECT_TRUE(bench.answers[0].done);
  EXPECT_EQ(bench.answers[0].map_version, 1);
  EXPECT_FALSE(bench.answers[1].done);
  EXPECT_EQ(bench.answers[1].reason, "the disk is full");

  Bench replay;
  replay.node().use(bench.answers);
  replay.send_sweep(0);
  EXPECT_TRUE(replay.answers.empty());
  EXPECT_EQ(replay.state().map_digest, bench.state().map_digest);
}

TEST(MapCommands, ALogsAnswersSayWhereACommandBelongsWheneverItComes) {
  Bench live;
  for (const int number : {0, 1}) live.send_sweep(number);
  live.withdraw("sweep 0");
  live.withdraw("sweep 9", kGiven + 1);
  live.send_sweep(2);
  ASSERT_EQ(live.state().map_version, 4);
  for (const bool command_first : {true, false}) {
    Bench replay;
    replay.node().use(live.answers);
    if (command_first) replay.withdraw("sweep 0");
    for (const int number : {0, 1, 2}) replay.send_sweep(number);
    if (!command_first) replay.withdraw("sweep 0");
    EXPECT_EQ(replay.state().map_version, 4);
    EXPECT_EQ(replay.state().map_digest, live.state().map_digest);
    EXPECT_TRUE(replay.octomap() == live.octomap());
    ASSERT_EQ(replay.answers.size(), live.answers.size());
    for (std::size_t i = 0; i < live.answers.size(); ++i) {
      EXPECT_EQ(encode(replay.answers[i]), encode(live.answers[i]));
    }
  }
}

TEST(MapCommands, ASweepStaysWithdrawnOverARestart) {
  const test::ScratchFolder scratch;
  const SweepStore store(scratch / "state");
  Bench before;
  before.node().keep_in(store);
  for (const int number : {0, 1}) before.send_sweep(number);
  before.withdraw("sweep 1");
  before.send_sweep(2);
  Bench after;
  after.node().restore(store);
  EXPECT_EQ(after.state().map_version, 4);
  EXPECT_EQ(after.state().map_digest, before.state().map_digest);
  EXPECT_TRUE(after.octomap() == before.octomap());
}

}  // namespace
}  // namespace scanway
