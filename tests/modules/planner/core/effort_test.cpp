#include <gtest/gtest.h>

#include "modules/planner/core/planner.h"
#include "tests/modules/planner/support/maps.h"
#include "tests/modules/planner/support/repairs.h"

namespace scanway::test {
namespace {

using planning::BodyMode;
using planning::Planner;
using planning::PlanResult;

std::uint64_t work(const PlanResult& plan) { return plan.effort.expansions + plan.effort.dropped; }

std::vector<Cell> tiles_of(const CellRectangle& cells) {
  std::vector<Cell> tiles;
  const Cell low = CostMap::tile_of(cells.low), high = CostMap::tile_of({cells.high.x - 1, cells.high.y - 1});
  for (Cell tile = low; tile.y <= high.y; ++tile.y) {
    for (tile.x = low.x; tile.x <= high.x; ++tile.x) tiles.push_back(tile);
  }
  return tiles;
}

PlanResult fresh_plan(const TestMap& map, BodyMode mode, Cell start, Cell goal) {
  Planner planner(Robot(), mode);
  planner.set_map(map.map, map.bounds);
  return planner.plan(middle_of(map.map, start), middle_of(map.map, goal));
}

struct EffortCase {
  const char* name;
  BodyMode mode;
  double resolution_m;
  double share;
  std::uint64_t least_gain;  ///< Of a driving robot's repairs against planning anew each time.
};

class Effort : public testing::TestWithParam<EffortCase> {
 protected:
  void SetUp() override {
    Random random(5);
    map = random_map(700, 700, GetParam().resolution_m, GetParam().share, false, random);
    for (const Cell& end : {start, goal})
      map.fill({{end.x - 12, end.y - 12}, {end.x + 13, end.y + 13}}, CellState::free);
    // The robot drives from cell to cell of its path.
    planner = std::make_unique<Planner>(Robot(), GetParam().mode, planning::PathForm::cells);
    planner->set_map(map.map, map.bounds);
    first = plan();
    ASSERT_EQ(first.reason, "ok");
  }
  PlanResult plan() { return planner->plan(middle_of(map.map, start), middle_of(map.map, goal)); }
  /// A wall of 1 x 15 cells; what planning then takes, after comparing the cost with a new planner's.
  PlanResult after_wall(Cell at) {
    const CellRectangle wall = {{at.x, at.y - 7}, {at.x + 1, at.y + 8}};
    map.fill(wall, CellState::occupied);
    planner->update(map.map, tiles_of(wall));
    const PlanResult result = plan();
    const PlanResult anew = fresh_plan(map, GetParam().mode, start, goal);
    EXPECT_EQ(result.reason, "ok");
    EXPECT_EQ(result.cost, anew.cost);
    searched_anew = work(anew);
    return result;
  }

  TestMap map;
  Cell start{40, 350};
  Cell goal{660, 360};
  std::unique_ptr<Planner> planner;
  PlanResult first;
  std::uint64_t searched_anew = 0;
};

TEST_P(Effort, AChangeNearTheGoalCostsNoMoreThanANewSearch) {
  const PlanResult result = after_wall({goal.x - 9, goal.y});
  // What was done before the planner noticed is lost: a tenth of a search dropped, and some of it found again.
  EXPECT_LE(result.effort.expansions, searched_anew * 11 / 10);
}

TEST_P(Effort, ADrivingRobotPaysOnce) {
  std::uint64_t total = 0, anew = 0;
  for (int step = 0; step < 40; ++step) {
    const auto& path = first.path;
    const auto at = std::min<std::size_t>(path.size() - 1, 12);
    start = {static_cast<std::int32_t>(path[at].x_m / GetParam().resolution_m),
             static_cast<std::int32_t>(path[at].y_m / GetParam().resolution_m)};
    const CellRectangle post = {{start.x + 8, start.y + 4}, {start.x + 10, start.y + 6}};
    map.fill(post, CellState::occupied);
    planner->update(map.map, tiles_of(post));
    first = plan();
    const PlanResult fresh = fresh_plan(map, GetParam().mode, start, goal);
    ASSERT_EQ(first.reason, fresh.reason);
    ASSERT_EQ(first.cost, fresh.cost);
    if (first.reason != "ok") break;
    total += work(first);
    anew += work(fresh);
  }
  EXPECT_LE(GetParam().least_gain * total, anew) << total << " of " << anew;
}

TEST_P(Effort, AGoalThatMovesIsFollowed) {
  std::uint64_t total = 0, anew = 0;
  for (int step = 0; step < 30; ++step) {
    goal.x -= 10;
    if (map.map.state(goal) != CellState::free) continue;
    const PlanResult result = plan();
    const PlanResult fresh = fresh_plan(map, GetParam().mode, start, goal);
    ASSERT_EQ(result.reason, fresh.reason);
    ASSERT_EQ(result.cost, fresh.cost);
    total += work(result);
    anew += work(fresh);
  }
  EXPECT_LE(5 * total, anew);
}

/// The bench's change of 200 x 200 cells on 4000 x 4000, at half the size: 10 cells from the robot a twentieth of the
/// cells become obstacles. On the same map a change of 200 x 200 takes a ninth.
TEST(NearTheRobot, AWideChangeCostsATenthOfTheFirstPlan) {
  Random random(6);
  TestMap map = free_map(2000, 2000, 1.0);
  const auto drop = [&](const CellRectangle& cells, std::uint64_t one_of) {
    for (Cell cell = cells.low; cell.y < cells.high.y; ++cell.y) {
      for (cell.x = cells.low.x; cell.x < cells.high.x; ++cell.x) {
        if (random.below(one_of) == 0) map.map.set_state(cell, CellState::occupied);
      }
    }
  };
  drop({{5, 5}, {1995, 1995}}, 5);
  Planner planner(Robot(), BodyMode::point);
  planner.set_map(map.map, map.bounds);
  const auto plan = [&] { return planner.plan({0.5, 0.5}, {1999.5, 1999.5}); };
  const PlanResult first = plan();
  const CellRectangle change = {{10, 10}, {110, 110}};
  drop(change, 20);
  planner.update(map.map, tiles_of(change));
  const PlanResult repaired = plan();
  ASSERT_EQ(repaired.reason, "ok");
  EXPECT_GT(repaired.cost, first.cost);
  EXPECT_EQ(repaired.cost, fresh_plan(map, BodyMode::point, {0, 0}, {1999, 1999}).cost);
  EXPECT_LE(10 * work(repaired), work(first)) << work(repaired) << " of " << work(first);
}

/// Where a change closes the only near door the way grows, and D* Lite looks at all between the two lengths: that is
/// part of the sum.
TEST(NearTheRobot, AChangeCostsATwentiethOfANewSearchOnEveryMap) {
  if (!has_moving_ai_maps()) GTEST_SKIP() << "no ../shared/data/grid_maps_movingai";
  for (const char* name : {"den520d", "AR0011SR", "16room_000", "random512-20-0", "maze512-8-0", "Berlin_0_256"}) {
    const NearRobotEffort effort = change_near_robot(name, 20);
    EXPECT_GT(effort.expansions, 0u) << name;
    EXPECT_GT(effort.changes, 20) << name;
    EXPECT_LE(20 * (effort.expansions + effort.dropped), effort.expansions_anew) << name;
  }
}

INSTANTIATE_TEST_SUITE_P(Modes, Effort,
                         testing::Values(EffortCase{"rubble", BodyMode::point, 0.05, 0.25, 10},
                                         EffortCase{"body", BodyMode::footprint, 0.05, 0.004, 5}),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace scanway::test
