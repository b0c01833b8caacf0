// A lawn with blades and a box in it, beside a paved court: what each setting of the robot file makes of it.
#include <gtest/gtest.h>

#include "modules/mapper/core/costmap/evidence_history.h"
#include "modules/mapper/core/costmap/look.h"
#include "tests/modules/mapper/core/costmap/truth/judged_map.h"

namespace scanway::testing {
namespace {

using namespace simulator;

const Rectangle kLawn{{1.5, -3.0}, {6.0, 3.0}}, kPaving{{-4.0, -3.0}, {-0.5, 3.0}};
const Rectangle kBox{{3.0, -0.25}, {3.5, 0.25}};

World court_with_lawn() {
  GroundPlan plan;
  plan.extent = {{-8.0, -8.0}, {8.0, 8.0}};
  plan.material = Material::paving;
  plan.levels = {{kLawn, 0.0, {0, 0}, true, Material::grass}};
  World world;
  world.extent = plan.extent;
  world.ground = plan.mesh();
  Random random(5);
  for (int i = 0; i < 1500; ++i) {  // Blades, 4 to 8 cm high.
    const double x = 1.5 + 4.5 * random.uniform(), y = -3.0 + 6.0 * random.uniform(),
                 up = 0.04 + 0.04 * random.uniform();
    const Eigen::Vector3d foot(x, y, 0.0), side(0.01, 0.02 * random.uniform(), 0.0);
    world.objects.add_triangle(foot - side, foot + side, foot + Eigen::Vector3d(0.0, 0.0, up),
                               {Material::leaf, Label::foliage, false});
  }
  add_block(world.objects, {kBox.low.x(), kBox.low.y(), 0.0}, {kBox.high.x(), kBox.high.y(), 0.5},
            {Material::wood, Label::furniture});
  return world;
}

CostMap map_with(Vegetation vegetation) {
  static const World world = court_with_lawn();
  SweepConfig config;
  config.thin = 2;
  config.seed = 7;
  Robot robot = simulated_robot();
  static const SimulatedSweep taken = simulate_sweep(world, {0.0, 0.0, 0.3}, robot, config);
  const MapPoints points = points_in_map(taken.sweep, taken.X_world_base, robot.laser.min_range_m, 80.0);
  robot.mapping.vegetation = vegetation;
  CostMap map;
  EvidenceHistory().put(map, 0, look(points, taken.sweep, taken.X_world_base, robot, 1).evidence);
  return map;
}

/// Cells of the rectangle, but not of patches that may hold the foot of the box.
int count_cells(const CostMap& map, const Rectangle& part, CellState state) {
  int count = 0;
  for (auto y = static_cast<std::int32_t>(part.low.y() * 100); y < part.high.y() * 100; ++y) {
    for (auto x = static_cast<std::int32_t>(part.low.x() * 100); x < part.high.x() * 100; ++x) {
      const bool by_box = x > 260 && x < 390 && y > -65 && y < 65;
      count += !by_box && map.state({x, y}) == state ? 1 : 0;
    }
  }
  return count;
}

int of_box(const CostMap& map) {
  int count = 0;
  for (std::int32_t y = -27; y < 27; ++y) {
    for (std::int32_t x = 297; x < 353; ++x) count += map.state({x, y}) == CellState::occupied ? 1 : 0;
  }
  return count;
}

TEST(VegetationSetting, ToPassBladesAreNoObstaclesAndTheBoxStays) {
  const CostMap ignored = map_with(Vegetation::ignore), passed = map_with(Vegetation::pass);
  const int blades = count_cells(ignored, kLawn, CellState::occupied);
  EXPECT_GT(blades, 500);
  EXPECT_LE(count_cells(passed, kLawn, CellState::occupied), blades / 5);
  EXPECT_EQ(of_box(passed), of_box(ignored));
  EXPECT_GT(of_box(passed), 20);
  EXPECT_EQ(count_cells(passed, kPaving, CellState::free), count_cells(ignored, kPaving, CellState::free));
}

TEST(VegetationSetting, ToAvoidTheLawnIsOccupiedAndThePavingFree) {
  const CostMap ignored = map_with(Vegetation::ignore), avoided = map_with(Vegetation::avoid);
  const int open = count_cells(ignored, kLawn, CellState::free);
  EXPECT_GT(open, 50'000);
  EXPECT_LE(count_cells(avoided, kLawn, CellState::free), open / 10);
  EXPECT_GE(count_cells(avoided, kPaving, CellState::free), count_cells(ignored, kPaving, CellState::free) * 99 / 100);
}

}  // namespace
}  // namespace scanway::testing
