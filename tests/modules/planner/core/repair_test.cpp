#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "modules/planner/core/planner.h"
#include "tests/modules/planner/support/maps.h"
#include "tests/modules/planner/support/reference.h"

namespace scanway::test {
namespace {

using planning::BodyMode;
using planning::Planner;
using planning::PlanResult;
using planning::PlanStatus;

struct Case {
  const char* name;
  BodyMode mode;
  UnknownPolicy unknown;
  std::int32_t side;
  int steps;
};

/// A square robot of about 3 x 3 cells and a little more, at 0.1 m a cell.
Robot small_robot(UnknownPolicy unknown) {
  Robot robot;
  robot.body.footprint = {{0.22, 0.13}, {-0.16, 0.13}, {-0.16, -0.13}, {0.22, -0.13}};
  robot.planning.unknown = unknown;
  return robot;
}

/// One random change; returns the tiles that it touched.
std::vector<Cell> disturb(TestMap& map, Cell start, Cell goal, BodyMode mode, Random& random) {
  const Cell at = random_cell(map.bounds, random);
  const auto side = static_cast<std::int32_t>(1 + random.below(random.below(8) == 0 ? 12 : 3));
  std::set<Cell> tiles;
  const auto kind = random.below(mode == BodyMode::point ? 3 : 4);
  for (std::int32_t y = at.y; y < std::min(at.y + side, map.bounds.high.y); ++y) {
    for (std::int32_t x = at.x; x < std::min(at.x + side, map.bounds.high.x); ++x) {
      if (Cell{x, y} == start || Cell{x, y} == goal) continue;
      if (kind == 3) {
        map.map.set_cost({x, y}, static_cast<std::uint32_t>(random.below(kCostOne)));
      } else {
        map.map.set_state({x, y}, static_cast<CellState>(kind));
      }
      tiles.insert(CostMap::tile_of({x, y}));
    }
  }
  return {tiles.begin(), tiles.end()};
}

Cell free_cell(const TestMap& map, Random& random) {
  while (true) {
    const Cell cell = random_cell(map.bounds, random);
    if (map.map.state(cell) == CellState::free) return cell;
  }
}

class Repair : public testing::TestWithParam<Case> {};

/// The repaired plan against a planner that starts from nothing, and against the Dijkstra of the tests.
TEST_P(Repair, CostsWhatAFullSearchCosts) {
  const Case& c = GetParam();
  Random random(7);
  TestMap map = random_map(c.side, c.side, 0.1, c.mode == BodyMode::footprint ? 0.03 : 0.2, true, random);
  if (c.mode != BodyMode::point) add_random_costs(map, random);
  const Robot robot = small_robot(c.unknown);
  Planner planner(robot, c.mode);
  planner.set_map(map.map, map.bounds);
  Cell start = free_cell(map, random), goal = free_cell(map, random);
  int found = 0, none = 0;
  for (int step = 0; step < c.steps; ++step) {
    const auto what = random.below(8);
    if (what == 0) start = free_cell(map, random);
    if (what == 1) goal = free_cell(map, random);
    if (what >= 2) planner.update(map.map, disturb(map, start, goal, c.mode, random));
    const PlanResult repaired = planner.plan(middle_of(map.map, start), middle_of(map.map, goal));
    Planner fresh(robot, c.mode);
    fresh.set_map(map.map, map.bounds);
    const PlanResult anew = fresh.plan(middle_of(map.map, start), middle_of(map.map, goal));
    ASSERT_EQ(repaired.status, anew.status) << "step " << step;
    ASSERT_EQ(repaired.cost, anew.cost) << "step " << step;
    if (c.mode != BodyMode::footprint) {
      const auto reference = dijkstra_cost(map, robot, c.mode, start, goal);
      ASSERT_EQ(repaired.status == PlanStatus::ok, reference.has_value()) << "step " << step;
      ASSERT_NEAR(repaired.cost, reference.value_or(0.0), 1e-9) << "step " << step;
    }
    (repaired.status == PlanStatus::ok ? found : none) += 1;
  }
  EXPECT_GT(found, c.steps / 20);
  EXPECT_GT(none, 0);
}

INSTANTIATE_TEST_SUITE_P(Modes, Repair,
                         testing::Values(Case{"point", BodyMode::point, UnknownPolicy::never, 40, 3000},
                                         Case{"point_price", BodyMode::point, UnknownPolicy::price, 40, 1000},
                                         Case{"paper", BodyMode::paper, UnknownPolicy::free, 40, 1000},
                                         Case{"footprint", BodyMode::footprint, UnknownPolicy::never, 50, 1500},
                                         Case{"footprint_price", BodyMode::footprint, UnknownPolicy::price, 50, 1500}),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace scanway::test
