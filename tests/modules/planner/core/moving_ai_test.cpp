#include <gtest/gtest.h>

#include "modules/planner/core/planner.h"
#include "tests/modules/planner/support/maps.h"

namespace scanway::test {
namespace {

using planning::BodyMode;
using planning::Planner;
using planning::PlanResult;

/// Every `stride`-th problem of a map; one planner for all of them, so that starts and goals jump.
void expect_optimal(const std::string& name, std::size_t stride) {
  if (!has_moving_ai_maps()) GTEST_SKIP() << "no ../shared/data/grid_maps_movingai";
  const TestMap map = moving_ai_map(name);
  const std::vector<Problem> problems = moving_ai_problems(name);
  ASSERT_GT(problems.size(), 100u);
  Planner planner(Robot(), BodyMode::point);
  planner.set_map(map.map, map.bounds);
  for (std::size_t i = 0; i < problems.size(); i += stride) {
    const Problem& problem = problems[i];
    const PlanResult plan = planner.plan(middle_of(map.map, problem.start), middle_of(map.map, problem.goal));
    ASSERT_EQ(plan.reason, "ok") << name << " problem " << i;
    ASSERT_NEAR(plan.length_m, problem.optimal_length, 0.01) << name << " problem " << i;
  }
}

TEST(MovingAi, Arena) { expect_optimal("arena", 1); }
TEST(MovingAi, Den520d) { expect_optimal("den520d", 7); }

}  // namespace
}  // namespace scanway::test
