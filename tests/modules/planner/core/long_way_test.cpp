#include <gtest/gtest.h>

#include <cmath>

#include "modules/planner/core/planner.h"
#include "tests/modules/planner/support/maps.h"

namespace scanway::test {
namespace {

using planning::BodyMode;
using planning::Planner;
using planning::PlanResult;

constexpr double kWay = 9000;

/// 9,100 x 40 cells of the highest price, 255 + 63/64 a metre: a way along it costs more than 40 bits of fine units.
class LongWay : public testing::Test {
 protected:
  LongWay() : map{{1.0, 0.0, 0.0, {}}, {{0, 0}, {9100, 40}}} {
    map.fill(map.bounds, CellState::unknown);
    robot.planning.unknown = UnknownPolicy::price;
    robot.planning.unknown_price = 1000.0;
  }
  PlanResult plan(Planner& planner, Cell goal) { return planner.plan({0.5, 0.5}, middle_of(map.map, goal)); }

  TestMap map;
  Robot robot;
};

TEST_F(LongWay, CostsWhatItsLengthTimesItsPriceIs) {
  Planner planner(robot, BodyMode::point);
  planner.set_map(map.map, map.bounds);
  const PlanResult straight = plan(planner, {9000, 0});
  ASSERT_EQ(straight.reason, "ok");
  EXPECT_NEAR(straight.length_m, kWay, 1e-9);
  EXPECT_NEAR(straight.cost, kWay * 16383 / 64, 1e-6);
  // 39 diagonal steps and the rest straight; a coarse diagonal is sqrt(2) to 7.2e-5.
  const PlanResult bent = plan(planner, {9000, 39});
  ASSERT_EQ(bent.reason, "ok");
  EXPECT_NEAR(bent.cost, (kWay - 39 + 39 * std::sqrt(2.0)) * 16383 / 64, 39 * 1.1e-4 * 16383 / 64);
}

TEST_F(LongWay, IsRepairedAtTheCostOfANewSearch) {
  Planner planner(robot, BodyMode::point);
  planner.set_map(map.map, map.bounds);
  plan(planner, {9000, 20});
  for (const std::int32_t x : {20, 900, 8990}) {
    map.fill({{x, 0}, {x + 1, 39}}, CellState::occupied);
    planner.update(map.map, {{x / 128, 0}});
    const PlanResult repaired = plan(planner, {9000, 20});
    Planner fresh(robot, BodyMode::point);
    fresh.set_map(map.map, map.bounds);
    ASSERT_EQ(repaired.reason, "ok");
    EXPECT_EQ(repaired.cost, plan(fresh, {9000, 20}).cost) << x;
    EXPECT_GT(repaired.cost, kWay * 16383 / 64);
  }
}

}  // namespace
}  // namespace scanway::test
