// What is published of a change, together with what was published before, is the whole map.
#include "modules/mapper/node/map_publisher.h"

#include <gtest/gtest.h>

#include <map>
#include <string>

#include "common/bus/channels.h"
#include "common/bus/memory_bus.h"
#include "common/messages/object_input.h"
#include "tests/modules/mapper/node/room.h"

namespace scanway {
namespace {

/// The cloud as a subscriber has it: every cube's points, without the version that it came with.
class Subscriber {
 public:
  explicit Subscriber(MemoryBus& bus) : bus_(bus) {
    bus.subscribe(channel::kCloudTile.name, [this](const BusMessage& message) {
      input_.take(message.bytes, [this](cloud_tile_t tile, const Object& object) {
        ++objects_;
        tile.utime = tile.map_version = 0;
        tile.npoints == 0 ? (void)cubes_.erase(object.key) : (void)cubes_.insert_or_assign(object.key, encode(tile));
      });
    });
  }
  /// How many cubes that took.
  int receive() {
    objects_ = 0;
    bus_.dispatch();
    return objects_;
  }
  const std::map<std::string, std::vector<std::uint8_t>>& cubes() const { return cubes_; }

 private:
  MemoryBus& bus_;
  ObjectInput<cloud_tile_t> input_;
  std::map<std::string, std::vector<std::uint8_t>> cubes_;
  int objects_ = 0;
};

class PublishedMap {
 public:
  PublishedMap() : publisher_(bus_), subscriber_(bus_) {}
  int publish(const Map& map, const MapChange& change) {
    publisher_.publish(map, change, 1);
    return subscriber_.receive();
  }
  int publish_whole(const Map& map) {
    publisher_.publish_whole(map, 1);
    return subscriber_.receive();
  }
  const auto& cubes() const { return subscriber_.cubes(); }

 private:
  MemoryBus bus_;
  MapPublisher publisher_;
  Subscriber subscriber_;
};

Robot with_small_products() {
  Robot robot;
  robot.mapping.cost_map_resolution_m = 0.1;
  robot.mapping.octomap_resolution_m = 0.2;
  return robot;
}

Pose shifted(double x_m) { return Pose(Eigen::Translation3d(x_m, 0.3, 1.0)); }

class MapPublisherTest : public testing::Test {
 protected:
  void expect_whole() {
    PublishedMap anew;
    anew.publish_whole(map_);
    EXPECT_TRUE(published_.cubes() == anew.cubes());
  }
  Map map_{with_small_products(), 1};
  PublishedMap published_;
};

TEST_F(MapPublisherTest, SendsOnlyCubesThatASweepTouchedAndTheyMakeTheWholeCloud) {
  const Sweep sweep = test::room(1, "room");
  const int first = published_.publish(map_, map_.merge(sweep, shifted(0.0)));
  expect_whole();
  published_.publish(map_, map_.merge(sweep, shifted(5.0)));
  expect_whole();
  const int far = published_.publish(map_, map_.merge(sweep, shifted(300.0)));
  EXPECT_LE(far, first + 8);
  EXPECT_GT(far, 0);
  expect_whole();
  published_.publish(map_, map_.move({{1, shifted(-2.0)}}));
  expect_whole();
  EXPECT_EQ(published_.publish(map_, map_.withdraw(2)), far);  // As many are empty now.
  expect_whole();
  published_.publish(map_, map_.withdraw(0));
  expect_whole();
}

TEST_F(MapPublisherTest, ACubeWhereOnlySomeSweepsHaveIntensitySaysZeroOfTheOthers) {
  Sweep sweep = test::room(1, "room");
  published_.publish(map_, map_.merge(sweep, shifted(0.0)));
  sweep.cloud.intensity.assign(sweep.cloud.size(), 7.0f);
  published_.publish(map_, map_.merge(sweep, shifted(6.0)));
  expect_whole();
  int with = 0;
  for (const auto& [key, bytes] : published_.cubes()) {
    const auto tile = decode<cloud_tile_t>(bytes);
    ASSERT_TRUE(tile.nintensities == 0 || tile.nintensities == tile.npoints) << key;
    with += tile.nintensities > 0 ? 1 : 0;
  }
  EXPECT_GT(with, 0);
}

}  // namespace
}  // namespace scanway
