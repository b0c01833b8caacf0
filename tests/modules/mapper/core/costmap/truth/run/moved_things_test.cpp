// What the next sweep finds gone is gone from the map; and one world, thinned, against its truth.
#include <algorithm>

#include <gtest/gtest.h>

#include "modules/mapper/core/costmap/evidence_history.h"
#include "modules/mapper/core/costmap/look.h"
#include "modules/simulator/core/world/ground_plan.h"
#include "tests/modules/mapper/core/costmap/truth/judged_map.h"

namespace scanway::testing {
namespace {

using namespace simulator;

constexpr int kThin = 2;
const Place kPlace{0.0, 0.0, 0.3};

/// A court of even ground as far as `ahead`, where the world ends.
World court(double ahead) {
  GroundPlan plan;
  plan.extent = {{-8.0, -8.0}, {ahead, 8.0}};
  World world;
  world.name = "court";
  world.extent = plan.extent;
  world.ground = plan.mesh();
  return world;
}

World with_box(World world, double x, double y) {
  add_block(world.objects, {x, y - 0.25, 0.0}, {x + 0.5, y + 0.25, 0.5}, {Material::wood, Label::furniture});
  return world;
}

class MapOfSweeps {
 public:
  void add(const World& world, std::uint64_t seed, int people = 0) {
    SweepConfig config;
    config.thin = kThin;
    config.seed = seed;
    config.people = people;
    const SimulatedSweep taken = simulate_sweep(world, kPlace, robot_, config);
    const MapPoints points = points_in_map(taken.sweep, taken.X_world_base, robot_.laser.min_range_m, 80.0);
    labels_ = taken.labels;
    history_.put(map_, number_++, look(points, taken.sweep, taken.X_world_base, robot_, 1).evidence);
  }
  int occupied(const Rectangle& part) const {
    int count = 0;
    for (auto y = static_cast<std::int32_t>(part.low.y() * 100); y < part.high.y() * 100; ++y) {
      for (auto x = static_cast<std::int32_t>(part.low.x() * 100); x < part.high.x() * 100; ++x) {
        count += map_.state({x, y}) == CellState::occupied ? 1 : 0;
      }
    }
    return count;
  }
  /// Cells that are occupied here and not there.
  int occupied_beyond(const MapOfSweeps& other) const {
    int count = 0;
    for (std::int32_t y = -500; y < 500; ++y) {
      for (std::int32_t x = -500; x < 500; ++x) {
        count += state(x, y) == CellState::occupied && other.state(x, y) != CellState::occupied ? 1 : 0;
      }
    }
    return count;
  }
  CellState state(std::int32_t x, std::int32_t y) const { return map_.state({x, y}); }
  std::ptrdiff_t points_on_people() const { return std::count(labels_.begin(), labels_.end(), Label::person); }

 private:
  Robot robot_ = simulated_robot();
  EvidenceHistory history_;
  SweepNumber number_ = 0;
  CostMap map_;
  std::vector<Label> labels_;
};

TEST(MovedThings, ABoxThatWasTakenAwayIsGone) {
  const World empty = court(8.0);
  MapOfSweeps map;
  map.add(with_box(empty, 3.0, 0.5), 1);
  EXPECT_GT(map.occupied({{2.8, 0.0}, {3.7, 1.0}}), 20);
  map.add(empty, 2);
  EXPECT_EQ(map.occupied({{2.8, 0.0}, {3.7, 1.0}}), 0);
}

TEST(MovedThings, AlsoWithNothingBehindIt) {
  const World empty = court(3.6);  // The box stands at the world's end: no ground behind it, no wall.
  MapOfSweeps map;
  map.add(with_box(empty, 3.0, 0.5), 1);
  EXPECT_GT(map.occupied({{2.8, 0.0}, {3.5, 1.0}}), 20);
  map.add(empty, 2);
  EXPECT_EQ(map.occupied({{2.8, 0.0}, {3.5, 1.0}}), 0);
}

TEST(MovedThings, PeopleWhoWalkedThroughASweepLeaveNothingAfterTheNext) {
  const World empty = court(8.0);
  MapOfSweeps map, never;
  map.add(empty, 3, 4);
  ASSERT_GT(map.points_on_people(), 100);
  never.add(empty, 4);
  EXPECT_GT(map.occupied_beyond(never), 20);
  map.add(empty, 4);
  EXPECT_EQ(map.occupied_beyond(never), 0);  // Within 5 m: further out a thinned sweep has gaps between its rings.
}

TEST(DropOffs, NearByTheEdgeOfATrenchIsMarkedAndNothingInItIsFree) {
  GroundPlan plan;
  plan.extent = {{-4.0, -4.0}, {6.0, 4.0}};
  plan.levels = {{{{1.2, -4.0}, {2.1, 4.0}}, -1.0, {0, 0}, true, Material::concrete}};
  World world = court(6.0);
  world.ground = plan.mesh();
  MapOfSweeps map;
  map.add(world, 5);
  int open = 0, unmarked = 0;
  for (std::int32_t y = -80; y < 80; ++y) {
    bool marked = false;
    for (std::int32_t x = 116; x <= 124; ++x) marked = marked || map.state(x, y) == CellState::occupied;
    unmarked += marked ? 0 : 1;
    for (std::int32_t x = 124; x < 206; ++x) open += map.state(x, y) == CellState::free ? 1 : 0;
  }
  EXPECT_EQ(unmarked, 0);
  EXPECT_EQ(open, 0);
}

TEST(CostMapTruth, AThinnedWorldIsRight) {
  SweepPlan plan;
  plan.thin = 4;  // A sixteenth of the points: rings are four times as far apart, so bounds are wide.
  const tools::MapComparison counts = judge(take_sweeps("flat", 21, plan)).counts;
  ASSERT_GT(counts.two.free, 1'000'000);
  EXPECT_LE(counts.two.free_called_occupied, counts.two.free / 1000);
  EXPECT_LE(counts.two.free_lost(), counts.two.free * 15 / 100);
  EXPECT_LE(counts.two.occupied_called_free, counts.two.occupied * 2 / 100);
}

}  // namespace
}  // namespace scanway::testing
