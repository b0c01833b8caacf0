#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numbers>

#include "common/grid/map_file.h"
#include "modules/planner/core/planner.h"
#include "tests/modules/planner/support/maps.h"
#include "tests/modules/planner/support/polygon_check.h"
#include "tests/modules/planner/support/reference.h"

namespace scanway::test {
namespace {

using planning::BodyMode;
using planning::Planner;
using planning::PlanResult;
using planning::PlanStatus;

Robot box(double front, double back, double half_width) {
  Robot robot;
  robot.body.footprint = {{front, half_width}, {-back, half_width}, {-back, -half_width}, {front, -half_width}};
  return robot;
}

const Robot kEraMobi;
const Robot kBox = box(0.6, 0.6, 0.25);
/// Its centre is over the rear axle.
const Robot kCar = box(3.6, 0.9, 0.9);

/// Plans between random places; returns how many paths there were.
int expect_all_clear(const TestMap& map, const Robot& robot, int problems, Random& random) {
  Planner planner(robot, BodyMode::footprint);
  planner.set_map(map.map, map.bounds);
  const PolygonCheck check(map, robot);
  int paths = 0;
  for (int i = 0; i < problems; ++i) {
    const PlanResult plan = planner.plan(middle_of(map.map, random_cell(map.bounds, random)),
                                         middle_of(map.map, random_cell(map.bounds, random)));
    if (plan.status != PlanStatus::ok) continue;
    ++paths;
    EXPECT_EQ(check.first_hit(plan.path), "");
  }
  return paths;
}

/// A cell where the body has room at heading 0; after a while, any cell.
Cell place_for(const TestMap& map, const Robot& robot, Random& random) {
  const PolygonCheck check(map, robot);
  Cell cell;
  for (int i = 0; i < 100; ++i) {
    cell = random_cell(map.bounds, random);
    if (!check.hits({cell.x, cell.y}, 0.0)) break;
  }
  return cell;
}

struct BodyCase {
  const char* name;
  Robot robot;
  double resolution_m;
  double share;
  int maps;  ///< For the exhaustive search, which is slow for large bodies.
};

class BodyOnRandomMaps : public testing::TestWithParam<BodyCase> {};

TEST_P(BodyOnRandomMaps, NoPoseOverlapsAnObstacle) {
  const BodyCase& c = GetParam();
  Random random(11);
  int paths = 0;
  for (int i = 0; i < 7; ++i) {
    const TestMap map = random_map(90, 70, c.resolution_m, c.share * (i % 3 + 1) / 3.0, i % 2 == 0, random);
    paths += expect_all_clear(map, c.robot, 10, random);
  }
  EXPECT_GT(paths, 10);
}

TEST_P(BodyOnRandomMaps, FindsAWayWhereverAnExhaustiveSearchDoes) {
  const BodyCase& c = GetParam();
  Random random(12);
  int ways = 0, none = 0;
  for (int i = 0; i < c.maps; ++i) {
    const TestMap map = random_map(24, 20, c.resolution_m, c.share, i % 3 == 0, random);
    const Cell start = place_for(map, c.robot, random), goal = place_for(map, c.robot, random);
    Planner planner(c.robot, BodyMode::footprint);
    planner.set_map(map.map, map.bounds);
    const PlanResult plan = planner.plan(middle_of(map.map, start), middle_of(map.map, goal));
    const auto of_8 = dijkstra_cost_of_body(map, c.robot, start, goal, 8);
    const auto of_16 = dijkstra_cost_of_body(map, c.robot, start, goal, 16);
    EXPECT_TRUE(!of_8 || plan.status == PlanStatus::ok) << "map " << i << ": " << plan.reason;
    EXPECT_EQ(plan.status == PlanStatus::ok, of_16.has_value()) << "map " << i;
    // The search samples turns and steps, and so allows a little more than the planner's exact sweeps.
    EXPECT_GE(plan.cost, of_16.value_or(0.0) - 1e-9) << "map " << i;
    EXPECT_LE(plan.cost, 1.05 * of_16.value_or(0.0)) << "map " << i;
    (of_16 ? ways : none) += 1;
  }
  EXPECT_GT(ways, 0);
  EXPECT_GT(none, 0);
}

INSTANTIATE_TEST_SUITE_P(Bodies, BodyOnRandomMaps,
                         testing::Values(BodyCase{"era_mobi", kEraMobi, 0.1, 0.04, 30},
                                         BodyCase{"box", kBox, 0.15, 0.03, 30}, BodyCase{"car", kCar, 0.6, 0.02, 5}),
                         [](const auto& test) { return test.param.name; });

class BodyOnRealMaps : public testing::TestWithParam<const char*> {};

TEST_P(BodyOnRealMaps, NoPoseOverlapsAnObstacle) {
  const std::string path = std::string(SCANWAY_SHARED_DIR) + "/data/occupancy_maps/" + GetParam() + ".yaml";
  if (!std::ifstream(path)) GTEST_SKIP() << "no " << path;
  TestMap map{read_map(path), {}};
  map.bounds = *bounds(map.map);
  Random random(13);
  for (const Robot& robot : {kEraMobi, kBox}) EXPECT_GT(expect_all_clear(map, robot, 12, random), 2);
}

INSTANTIATE_TEST_SUITE_P(Maps, BodyOnRealMaps, testing::Values("depot", "warehouse"));

/// A wall across the map with one gap of so many cells, turned by an angle.
TestMap wall_with_gap(double gap_m, double angle) {
  TestMap map = free_map(300, 300, 0.01);
  const double c = std::cos(angle), s = std::sin(angle);
  for (std::int32_t y = 0; y < 300; ++y) {
    for (std::int32_t x = 0; x < 300; ++x) {
      const double px = (x + 0.5) * 0.01 - 1.5, py = (y + 0.5) * 0.01 - 1.5;
      const double across = c * px + s * py, along = -s * px + c * py;
      if (std::fabs(across) < 0.05 && std::fabs(along) > gap_m / 2.0) map.map.set_state({x, y}, CellState::occupied);
    }
  }
  return map;
}

PlanResult through(const TestMap& map, double angle) {
  Planner planner(kEraMobi, BodyMode::footprint);
  planner.set_map(map.map, map.bounds);
  const Eigen::Vector2d away(std::cos(angle), std::sin(angle));
  return planner.plan(Eigen::Vector2d(1.5, 1.5) - away, Eigen::Vector2d(1.5, 1.5) + away);
}

TEST(Doorway, EraMobiPassesHalfAMetreAtEveryAngle) {
  for (int degrees = 0; degrees < 90; degrees += 5) {
    const double angle = degrees * std::numbers::pi / 180.0;
    const TestMap map = wall_with_gap(0.5, angle);
    const PlanResult plan = through(map, angle);
    EXPECT_EQ(plan.reason, "ok") << degrees << " degrees";
    EXPECT_EQ(PolygonCheck(map, kEraMobi).first_hit(plan.path), "");
  }
}

TEST(Doorway, EraMobiPassesWhatItJustFits) {
  EXPECT_EQ(through(wall_with_gap(0.42, 0.0), 0.0).reason, "ok");
  const PlanResult plan = through(wall_with_gap(0.40, 0.0), 0.0);
  EXPECT_EQ(plan.status, PlanStatus::too_narrow);
  EXPECT_NE(plan.reason.find("0.40 m wide"), std::string::npos) << plan.reason;
}

TEST(Doorway, ClearanceIsTheFootprintsOwn) {
  const PlanResult plan = through(wall_with_gap(0.61, 0.0), 0.0);
  ASSERT_EQ(plan.reason, "ok");
  EXPECT_LE(plan.clearance_m, 0.1 + 1e-9);
  EXPECT_GE(plan.clearance_m, 0.08);
  EXPECT_NEAR(plan.clearance_at_m.x(), 1.5, 0.3);
}

}  // namespace
}  // namespace scanway::test
