#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "modules/planner/core/planner.h"
#include "tests/modules/planner/support/maps.h"

namespace scanway::test {
namespace {

using planning::BodyMode;
using planning::Planner;
using planning::PlanResult;
using planning::PlanStatus;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

PlanResult plan_on(const TestMap& map, UnknownPolicy unknown, BodyMode mode = BodyMode::point,
                   Eigen::Vector2d start = {1.05, 1.05}, Eigen::Vector2d goal = {4.05, 1.05}) {
  Robot robot;
  robot.planning.unknown = unknown;
  Planner planner(robot, mode);
  planner.set_map(map.map, map.bounds);
  return planner.plan(start, goal);
}

/// 6 m x 2 m, with what stands between x = 2.5 m and 2.8 m.
TestMap room(CellState between) {
  TestMap map = free_map(60, 20, 0.1);
  map.fill({{25, 0}, {28, 20}}, between);
  return map;
}

TEST(Answer, NothingIsKnown) {
  EXPECT_EQ(plan_on({}, UnknownPolicy::never).status, PlanStatus::no_map);
  Planner planner(Robot(), BodyMode::footprint);
  EXPECT_EQ(planner.plan({0, 0}, {1, 1}).status, PlanStatus::no_map);
}

TEST(Answer, WhatIsWrongWithStartAndGoal) {
  TestMap map = free_map(60, 20, 0.1);
  map.map.set_state({10, 10}, CellState::occupied);
  map.map.set_state({40, 10}, CellState::unknown);
  const auto status = [&](Eigen::Vector2d start, Eigen::Vector2d goal, BodyMode mode) {
    return plan_on(map, UnknownPolicy::never, mode, start, goal).status;
  };
  const Eigen::Vector2d good(2.05, 1.05), occupied(1.05, 1.05), unknown(4.05, 1.05), beside(1.15, 1.05);
  EXPECT_EQ(status(good, {3.05, 1.05}, BodyMode::point), PlanStatus::ok);
  EXPECT_EQ(status(occupied, good, BodyMode::point), PlanStatus::start_in_obstacle);
  EXPECT_EQ(status(good, occupied, BodyMode::point), PlanStatus::goal_in_obstacle);
  EXPECT_EQ(status(unknown, good, BodyMode::point), PlanStatus::start_unknown);
  EXPECT_EQ(status(good, unknown, BodyMode::point), PlanStatus::goal_unknown);
  EXPECT_EQ(status(beside, good, BodyMode::point), PlanStatus::ok);
  EXPECT_EQ(status(beside, good, BodyMode::footprint), PlanStatus::start_too_tight);
  EXPECT_EQ(status(good, beside, BodyMode::footprint), PlanStatus::goal_too_tight);
  for (const Eigen::Vector2d& off : {Eigen::Vector2d(-0.01, 1.0),
                                     {6.0, 1.0},
                                     {1e300, 1.0},
                                     {1.0, -1e300},
                                     {kNaN, 1.0},
                                     {1.0, kNaN},
                                     {HUGE_VAL, 1.0},
                                     {1.0, 2.0}}) {
    EXPECT_EQ(status(off, good, BodyMode::point), PlanStatus::start_off_map) << off.transpose();
    EXPECT_EQ(status(good, off, BodyMode::point), PlanStatus::goal_off_map) << off.transpose();
  }
}

TEST(Answer, WalledIn) {
  for (const auto policy : {UnknownPolicy::never, UnknownPolicy::price, UnknownPolicy::free}) {
    EXPECT_EQ(plan_on(room(CellState::occupied), policy).status, PlanStatus::walled_in);
    EXPECT_EQ(plan_on(room(CellState::occupied), policy, BodyMode::footprint).status, PlanStatus::walled_in);
  }
}

TEST(Answer, UnknownIsCrossedAsThePolicySays) {
  const TestMap map = room(CellState::unknown);
  EXPECT_EQ(plan_on(map, UnknownPolicy::never).status, PlanStatus::only_through_unknown);
  EXPECT_EQ(plan_on(map, UnknownPolicy::never, BodyMode::footprint).status, PlanStatus::only_through_unknown);
  const PlanResult price = plan_on(map, UnknownPolicy::price);
  const PlanResult free = plan_on(map, UnknownPolicy::free);
  EXPECT_NEAR(price.length_m, 3.0, 1e-9);
  EXPECT_NEAR(free.cost, 3.0, 1e-9);
  // 0.3 m of unknown at 1 + 4 a metre.
  EXPECT_NEAR(price.cost, 3.0 + 4.0 * 0.3, 1e-9);
  EXPECT_NEAR(price.unknown_share, 0.1, 1e-9);
  EXPECT_NEAR(free.unknown_share, 0.1, 1e-9);
  EXPECT_TRUE(std::isinf(free.clearance_m));
}

TEST(Answer, ADetourIsTakenWhereUnknownCostsMore) {
  TestMap map = room(CellState::unknown);
  map.fill({{25, 0}, {28, 2}}, CellState::free);
  EXPECT_EQ(plan_on(map, UnknownPolicy::price).unknown_share, 0.0);
  EXPECT_GT(plan_on(map, UnknownPolicy::free).unknown_share, 0.0);
}

TEST(Answer, TooNarrowSaysWhereAndHowWide) {
  TestMap map = room(CellState::occupied);
  map.fill({{25, 9}, {28, 12}}, CellState::free);
  EXPECT_EQ(plan_on(map, UnknownPolicy::never).status, PlanStatus::ok);
  const PlanResult plan = plan_on(map, UnknownPolicy::never, BodyMode::footprint);
  EXPECT_EQ(plan.status, PlanStatus::too_narrow);
  EXPECT_NE(plan.reason.find("0.30 m wide"), std::string::npos) << plan.reason;
}

TEST(Answer, CostsWeighInModePaperAndNotForAPoint) {
  TestMap map = free_map(60, 20, 0.1);
  for (std::int32_t x = 0; x < 60; ++x) {
    for (std::int32_t y = 0; y < 20; ++y) map.map.set_cost({x, y}, kCostOne / 2);
  }
  EXPECT_NEAR(plan_on(map, UnknownPolicy::never).cost, 3.0, 1e-9);
  EXPECT_NEAR(plan_on(map, UnknownPolicy::never, BodyMode::paper).cost, 3.0 * (1.0 + 3.0 * 0.5), 1e-9);
}

TEST(Answer, StartIsTheGoal) {
  const TestMap map = free_map(60, 20, 0.1);
  const PlanResult plan = plan_on(map, UnknownPolicy::never, BodyMode::footprint, {1.05, 1.05}, {1.07, 1.02});
  EXPECT_EQ(plan.reason, "ok");
  EXPECT_EQ(plan.length_m, 0.0);
  ASSERT_EQ(plan.path.size(), 1u);
}

TEST(Answer, AMapThatGrowsIsPlannedOn) {
  for (const auto policy : {UnknownPolicy::never, UnknownPolicy::free}) {
    TestMap map = free_map(128, 128, 0.1);
    Robot robot;
    robot.planning.unknown = policy;
    Planner planner(robot, BodyMode::footprint);
    planner.set_map(map.map);
    EXPECT_EQ(planner.plan({1, 1}, {12, 12}).reason, "ok");
    EXPECT_EQ(planner.plan({1, 1}, {15, 12}).status, PlanStatus::goal_off_map);
    for (std::int32_t tile = 1; tile < 12; ++tile) {
      map.fill({{tile * 128, 0}, {tile * 128 + 128, 128}}, CellState::free);
      planner.update(map.map, {{tile, 0}});
      const PlanResult plan = planner.plan({1, 1}, {tile * 12.8 + 6, 12});
      EXPECT_EQ(plan.reason, "ok") << tile;
      Planner fresh(robot, BodyMode::footprint);
      fresh.set_map(map.map);
      EXPECT_EQ(plan.cost, fresh.plan({1, 1}, {tile * 12.8 + 6, 12}).cost);
    }
  }
}

}  // namespace
}  // namespace scanway::test
