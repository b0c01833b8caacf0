#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "modules/planner/core/planner.h"
#include "tests/modules/planner/support/body_trials.h"
#include "tests/modules/planner/support/maps.h"
#include "tests/modules/planner/support/polygon_check.h"

namespace scanway::test {
namespace {

using planning::BodyMode;
using planning::Planner;
using planning::PlanResult;
using planning::PlanStatus;

const Robot kEraMobi;

class BodyTrials : public testing::TestWithParam<TrialBody> {};

TEST_P(BodyTrials, OnRandomMapsNoPoseOverlapsAnObstacle) {
  const TrialBody& body = GetParam();
  for (int i = 0; i < 4; ++i) {
    Random random(static_cast<std::uint64_t>(i));
    const double share = body.share * (i % 3 + 1) / 3.0;
    TestMap map = random_map(90, 70, body.resolution_m, share, i % 2 == 0, random);
    add_random_costs(map, random);
    Random same = random;
    const Tally smooth = try_random_problems(map, body.robot, 10, random);
    const Tally cells = try_random_problems(map, body.robot, 10, same, planning::PathForm::cells);
    EXPECT_GT(smooth.ways, 2);
    EXPECT_EQ(smooth.ways, cells.ways);
    EXPECT_EQ(smooth.cost, cells.cost);
    EXPECT_LT(smooth.seconds, cells.seconds);
  }
}

TEST_P(BodyTrials, InSimulatedWorldsNoPoseOverlapsAnObstacle) {
  const TrialBody& body = GetParam();
  Random random(14);
  const TestMap map = truth_map("car_park", 5, body.robot, 0.1);
  EXPECT_GT(try_random_problems(map, body.robot, 30, random).ways, 5);
}

TEST_P(BodyTrials, FindsAWayWhereverAnExhaustiveSearchDoes) {
  const TrialBody& body = GetParam();
  Random random(12);
  const Tally tally = try_against_exhaustive_search(body, std::string(body.name) == "car" ? 5 : 30, random);
  EXPECT_GT(tally.ways, 0);
  EXPECT_GT(tally.none, 0);
}

INSTANTIATE_TEST_SUITE_P(Bodies, BodyTrials, testing::ValuesIn(trial_bodies()),
                         [](const auto& test) { return test.param.name; });

class BodyOnRecordedMaps : public testing::TestWithParam<const char*> {};

TEST_P(BodyOnRecordedMaps, NoPoseOverlapsAnObstacle) {
  const TestMap map = recorded_map(GetParam());
  if (map.map.tiles.empty()) GTEST_SKIP() << "no ../shared/data/occupancy_maps";
  Random random(13);
  for (const TrialBody& body : trial_bodies()) {
    if (std::string(body.name) == "car") continue;  // Nothing here is made for cars.
    EXPECT_GT(try_random_problems(map, body.robot, 6, random).ways, 1);
  }
}

INSTANTIATE_TEST_SUITE_P(Maps, BodyOnRecordedMaps, testing::Values("depot", "warehouse"));

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
