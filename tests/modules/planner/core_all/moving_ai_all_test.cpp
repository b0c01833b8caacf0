#include <gtest/gtest.h>

#include "modules/planner/core/planner.h"
#include "tests/modules/planner/support/maps.h"

namespace scanway::test {
namespace {

class MovingAiAll : public testing::TestWithParam<const char*> {};

TEST_P(MovingAiAll, EveryProblemIsOptimal) {
  if (!has_moving_ai_maps()) GTEST_SKIP() << "no ../shared/data/grid_maps_movingai";
  const TestMap map = moving_ai_map(GetParam());
  planning::Planner planner(Robot(), planning::BodyMode::point);
  planner.set_map(map.map, map.bounds);
  for (const Problem& problem : moving_ai_problems(GetParam())) {
    const auto plan = planner.plan(middle_of(map.map, problem.start), middle_of(map.map, problem.goal));
    ASSERT_EQ(plan.reason, "ok");
    ASSERT_NEAR(plan.length_m, problem.optimal_length, 0.01);
  }
}

INSTANTIATE_TEST_SUITE_P(Maps, MovingAiAll,
                         testing::Values("arena", "den520d", "AR0011SR", "16room_000", "random512-20-0", "maze512-8-0",
                                         "Berlin_0_256"));

}  // namespace
}  // namespace scanway::test
