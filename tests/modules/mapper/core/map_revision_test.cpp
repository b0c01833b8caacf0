// Sweeps that are withdrawn or moved leave the products of a map that never had them there.
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "common/random/random.h"
#include "modules/mapper/core/map.h"
#include "tests/modules/mapper/core/costmap/scene.h"

namespace scanway {
namespace {

struct View {
  Sweep sweep;
  Pose X_map_sweep = Pose::Identity();
};
using Views = std::vector<View>;

/// Sweeps all about the furnished room, a box in another place in each, every 3 degrees.
Views views_of_a_room(std::size_t count) {
  Random random(11);
  Views views(count);
  for (std::size_t i = 0; i < count; ++i) {
    testing::Scene scene = testing::furnished_room();
    const double x = 4.0 * random.uniform() - 2.0, y = 2.0 * random.uniform() - 1.5;
    scene.boxes.push_back({{x, y, 0.0}, {x + 0.4, y + 0.3, 0.5}});
    const Eigen::Vector3d sensor(0.4 * static_cast<double>(i % 4) - 0.6, 0.3 * static_cast<double>(i % 3) - 0.4, 1.3);
    views[i].sweep = testing::scan(scene, sensor, 3.0, 3.0, 0.005, i + 1);
    for (Eigen::Vector3f& p : views[i].sweep.cloud.points) p -= sensor.cast<float>();
    views[i].sweep.origin.setZero();
    views[i].X_map_sweep.translation() = sensor;
    if (i % 2 == 0) views[i].sweep.cloud.intensity.assign(views[i].sweep.cloud.size(), static_cast<float>(i));
  }
  return views;
}

constexpr std::size_t kNone = 1000;

/// With larger cells, for there are ninety maps' sweeps to lay.
Robot with_large_cells() {
  Robot robot;
  robot.mapping.cost_map_resolution_m = 0.05;
  return robot;
}

void merge_all(Map& map, const Views& views, std::size_t without = kNone) {
  for (std::size_t i = 0; i < views.size(); ++i) {
    if (i != without) map.merge(views[i].sweep, views[i].X_map_sweep);
  }
}

using Tiles = std::map<Cell, CostTile>;

/// Every product, byte for byte.
struct Products {
  explicit Products(const Map& map)
      : cloud(map.cloud().centroids()), octomap(map.occupancy_tree().ot_bytes()), tiles(map.cost_map().tiles) {}
  bool operator==(const Products& other) const {
    return cloud.points == other.cloud.points && cloud.normals == other.cloud.normals &&
           cloud.intensity == other.cloud.intensity && octomap == other.octomap && tiles == other.tiles;
  }
  PointCloud cloud;
  std::string octomap;
  Tiles tiles;
};

Products products_of(const Robot& robot, const Views& views, std::size_t without = kNone) {
  Map map(robot, 1);
  merge_all(map, views, without);
  return Products(map);
}

/// What a subscriber has who is told of each change.
void follow(Tiles& known, const Map& map, const MapChange& change) {
  for (const Cell& changed : change.changed_tiles) {
    known.erase(changed);
    const auto tile = map.cost_map().tiles.find(changed);
    if (tile != map.cost_map().tiles.end()) known.insert(*tile);
  }
}

TEST(MapRevision, AnySweepOfTenIsWithdrawnAndPutBack) {
  const Views views = views_of_a_room(10);
  const Robot robot = with_large_cells();
  Map map(robot, 1);
  merge_all(map, views);
  const Products all(map);
  Tiles known = all.tiles;
  std::uint64_t version = map.version();
  for (std::size_t i = 0; i < views.size(); ++i) {
    MapChange change = map.withdraw(i);
    follow(known, map, change);
    EXPECT_EQ(change.version, ++version);
    EXPECT_FALSE(map.holds(i));
    EXPECT_TRUE(Products(map) == products_of(robot, views, i)) << "without sweep " << i;
    EXPECT_TRUE(known == map.cost_map().tiles) << "without sweep " << i;
    EXPECT_THROW(map.withdraw(i), std::logic_error);

    change = map.move({{i, views[i].X_map_sweep}});
    follow(known, map, change);
    EXPECT_EQ(change.version, ++version);
    EXPECT_TRUE(Products(map) == all) << "with sweep " << i << " put back";
    EXPECT_TRUE(known == all.tiles) << "with sweep " << i << " put back";
  }
}

/// Cells about (x, y) that are occupied in one and not in the other.
int occupied_beyond(const Map& one, const Map& other, double x, double y) {
  int count = 0;
  const double cell_m = one.cost_map().resolution_m;
  const auto middle_x = static_cast<std::int32_t>(x / cell_m), middle_y = static_cast<std::int32_t>(y / cell_m);
  for (std::int32_t i = middle_x - 12; i <= middle_x + 12; ++i) {
    for (std::int32_t j = middle_y - 12; j <= middle_y + 12; ++j) {
      const bool there = one.cost_map().state({i, j}) == CellState::occupied;
      count += there && other.cost_map().state({i, j}) != CellState::occupied ? 1 : 0;
    }
  }
  return count;
}

TEST(MapRevision, ABoxOrAPersonThatLeftIsGoneWithTheNextSweep) {
  const double x = 0.9, y = -1.0;
  const Eigen::Vector3d sensor(-0.6, 0.2, 1.3);
  // Finer than a cell is wide: what falls between two beams keeps what an older sweep saw there.
  const auto seen = [&sensor](const testing::Scene& scene, std::uint64_t seed) {
    return testing::scan(scene, sensor, 0.5, 0.4, 0.005, seed);
  };
  for (const Eigen::Vector3d& size : {Eigen::Vector3d(0.5, 0.5, 0.5), Eigen::Vector3d(0.3, 0.4, 1.75)}) {
    testing::Scene scene = testing::furnished_room();
    const Sweep without = seen(scene, 2);
    scene.boxes.push_back(
        {{x - 0.5 * size.x(), y - 0.5 * size.y(), 0.0}, {x + 0.5 * size.x(), y + 0.5 * size.y(), size.z()}});
    Map map(with_large_cells(), 1), never(with_large_cells(), 1);
    never.merge(without, Pose::Identity());
    map.merge(seen(scene, 1), Pose::Identity());
    EXPECT_GT(occupied_beyond(map, never, x, y), 5) << size.transpose();
    map.merge(without, Pose::Identity());
    EXPECT_EQ(occupied_beyond(map, never, x, y), 0) << size.transpose();
  }
}

TEST(MapRevision, PosesThatMoveBeforeASweepComesAreThoseOfAMapThatHadThemFromTheStart) {
  const Views right = views_of_a_room(6);
  Map map(Robot{}, 1);
  std::vector<SweepMove> moves;
  for (std::size_t i = 0; i + 1 < right.size(); ++i) {
    Pose wrong = right[i].X_map_sweep * Eigen::Translation3d(0.05 * static_cast<double>(i), -0.04, 0.0);
    wrong.linear() = rotation_about_z(0.02 * static_cast<double>(i));
    map.merge(right[i].sweep, i == 2 ? right[i].X_map_sweep : wrong);
    if (i != 2) moves.push_back({i, right[i].X_map_sweep});
  }
  Tiles known = map.cost_map().tiles;
  const MapChange change = map.merge(right.back().sweep, right.back().X_map_sweep, nullptr, moves);
  follow(known, map, change);
  EXPECT_EQ(change.version, right.size());
  EXPECT_TRUE(change.ground.plane.has_value());
  EXPECT_TRUE(Products(map) == products_of(Robot{}, right));
  EXPECT_TRUE(known == map.cost_map().tiles);
}

TEST(MapRevision, ByThePapersProjectionToo) {
  Robot robot;
  robot.mapping.paper_projection = true;
  robot.mapping.embodiment = Embodiment::paper;
  const Views views = views_of_a_room(3);
  for (std::size_t i = 0; i < views.size(); ++i) {
    Map map(robot, 1);
    merge_all(map, views);
    map.withdraw(i);
    EXPECT_TRUE(Products(map) == products_of(robot, views, i)) << "without sweep " << i;
  }
}

TEST(MapRevision, WithoutSweepsNothingIsLeft) {
  const Views views = views_of_a_room(2);
  Map map(Robot{}, 1);
  merge_all(map, views);
  map.withdraw(0);
  map.withdraw(1);
  EXPECT_TRUE(Products(map) == Products(Map(Robot{}, 1)));
  EXPECT_THROW(map.withdraw(2), std::logic_error);
  EXPECT_THROW(map.move({{2, Pose::Identity()}}), std::logic_error);
}

}  // namespace
}  // namespace scanway
