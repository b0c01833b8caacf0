#include "tests/modules/planner/support/repairs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/modules/planner/support/maps.h"
#include "tests/modules/planner/support/reference.h"

namespace scanway::test {
namespace {

using planning::BodyMode;
using planning::Planner;
using planning::PlanResult;
using planning::PlanStatus;

/// A robot of about 4 x 3 cells at 0.1 m a cell.
Robot small_robot(UnknownPolicy unknown) {
  Robot robot;
  robot.body.footprint = {{0.22, 0.13}, {-0.16, 0.13}, {-0.16, -0.13}, {0.22, -0.13}};
  robot.planning.unknown = unknown;
  return robot;
}

constexpr auto kCosts = std::uint64_t{3};

/// A state, or kCosts. A body needs more that is free than a point, or soon there is no way left.
std::uint64_t kind_of_change(BodyMode mode, Random& random) {
  if (mode == BodyMode::point) return random.below(3);
  const auto kind = random.below(mode == BodyMode::footprint ? 10 : 4);
  return kind > kCosts ? static_cast<std::uint64_t>(CellState::free) : kind;
}

/// One random change; returns the tiles that it touched.
std::vector<Cell> disturb(TestMap& map, Cell start, Cell goal, BodyMode mode, Random& random) {
  const Cell at = random_cell(map.bounds, random);
  const auto side = static_cast<std::int32_t>(1 + random.below(random.below(8) == 0 ? 12 : 3));
  std::set<Cell> tiles;
  const auto kind = kind_of_change(mode, random);
  for (std::int32_t y = at.y; y < std::min(at.y + side, map.bounds.high.y); ++y) {
    for (std::int32_t x = at.x; x < std::min(at.x + side, map.bounds.high.x); ++x) {
      if (Cell{x, y} == start || Cell{x, y} == goal) continue;
      if (kind == kCosts) {
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

PlanResult fresh_plan(const TestMap& map, const Robot& robot, BodyMode mode, Cell start, Cell goal) {
  Planner planner(robot, mode);
  planner.set_map(map.map, map.bounds);
  return planner.plan(middle_of(map.map, start), middle_of(map.map, goal));
}

Cell cell_on(const PlanResult& plan, std::size_t at) {
  const planning::PathPose& pose = plan.path.at(at);
  return {static_cast<std::int32_t>(pose.x_m), static_cast<std::int32_t>(pose.y_m)};
}

/// One robot on its way through a map of 1 m a cell.
class Drive {
 public:
  Drive(const TestMap& map, Cell goal) : map_(map), goal_(goal), planner_(Robot(), BodyMode::point) {
    planner_.set_map(map_.map, map_.bounds);
  }

  PlanResult plan(Cell start) { return planner_.plan(middle_of(map_.map, start), middle_of(map_.map, goal_)); }

  /// A block of `side` cells about `middle` appears and vanishes.
  void block(Cell start, Cell middle, std::int32_t side, NearRobotEffort& effort) {
    const CostMap before = map_.map;
    std::set<Cell> tiles;
    for (std::int32_t y = middle.y - side / 2; y <= middle.y + side / 2; ++y) {
      for (std::int32_t x = middle.x - side / 2; x <= middle.x + side / 2; ++x) {
        if (!map_.bounds.contains({x, y}) || Cell{x, y} == start || Cell{x, y} == goal_) continue;
        map_.map.set_state({x, y}, CellState::occupied);
        tiles.insert(CostMap::tile_of({x, y}));
      }
    }
    const std::vector<Cell> changed(tiles.begin(), tiles.end());
    replan(start, changed, effort);
    map_.map = before;
    replan(start, changed, effort);
  }

 private:
  void replan(Cell start, const std::vector<Cell>& changed, NearRobotEffort& effort) {
    planner_.update(map_.map, changed);
    const PlanResult repaired = plan(start);
    const PlanResult fresh = fresh_plan(map_, Robot(), BodyMode::point, start, goal_);
    EXPECT_EQ(repaired.reason, fresh.reason);
    EXPECT_EQ(repaired.cost, fresh.cost);
    if (fresh.status != PlanStatus::ok) return;
    effort.expansions += repaired.effort.expansions;
    effort.dropped += repaired.effort.dropped;
    effort.expansions_anew += fresh.effort.expansions;
    ++effort.changes;
  }

  TestMap map_;
  Cell goal_;
  Planner planner_;
};

}  // namespace

void expect_repairs_to_cost_what_full_searches_do(const RepairCase& repair, std::uint64_t seed) {
  Random random(seed);
  TestMap map =
      random_map(repair.side, repair.side, 0.1, repair.mode == BodyMode::footprint ? 0.03 : 0.2, true, random);
  if (repair.mode != BodyMode::point) add_random_costs(map, random);
  const Robot robot = small_robot(repair.unknown);
  Planner planner(robot, repair.mode);
  planner.set_map(map.map, map.bounds);
  Planner forgetful(robot, repair.mode);
  Cell start = free_cell(map, random), goal = free_cell(map, random);
  int found = 0, none = 0;
  for (int step = 0; step < repair.steps; ++step) {
    const auto what = random.below(8);
    if (what == 0) start = free_cell(map, random);
    if (what == 1) goal = free_cell(map, random);
    if (what >= 2) planner.update(map.map, disturb(map, start, goal, repair.mode, random));
    const PlanResult repaired = planner.plan(middle_of(map.map, start), middle_of(map.map, goal));
    if (repair.mode == BodyMode::footprint || step % 8 == 0) {
      forgetful.set_map(map.map, map.bounds);
      const PlanResult anew = forgetful.plan(middle_of(map.map, start), middle_of(map.map, goal));
      ASSERT_EQ(repaired.status, anew.status) << "step " << step;
      ASSERT_EQ(repaired.cost, anew.cost) << "step " << step;
    }
    if (repair.mode != BodyMode::footprint) {
      const auto reference = dijkstra_cost(map, robot, repair.mode, start, goal);
      ASSERT_EQ(repaired.status == PlanStatus::ok, reference.has_value()) << "step " << step;
      ASSERT_NEAR(repaired.cost, reference.value_or(0.0), 1e-9) << "step " << step;
    }
    (repaired.status == PlanStatus::ok ? found : none) += 1;
  }
  EXPECT_GT(found, repair.steps / 20);
  EXPECT_GT(none, 0);
}

NearRobotEffort change_near_robot(const std::string& name, std::size_t stride) {
  const TestMap map = moving_ai_map(name);
  const std::vector<Problem> problems = moving_ai_problems(name);
  Random random(3);
  NearRobotEffort effort;
  for (std::size_t i = problems.size() - 100; i < problems.size(); i += stride) {
    Drive drive(map, problems[i].goal);
    const PlanResult whole = drive.plan(problems[i].start);
    for (std::size_t fifth = 0; fifth < 4; ++fifth) {
      const Cell robot = cell_on(whole, whole.path.size() * fifth / 5);
      for (const std::int32_t side : {1, 3}) {
        const PlanResult rest = drive.plan(robot);
        // Every cell is on the path twice, with two headings, where it turns: at most 28 cells ahead.
        const std::size_t ahead = 10 + 2 * random.below(10);
        drive.block(robot, cell_on(rest, std::min(ahead, rest.path.size() / 2)), side, effort);
      }
    }
  }
  return effort;
}

}  // namespace scanway::test
