#include <gtest/gtest.h>

#include <algorithm>

#include "tests/modules/planner/support/maps.h"
#include "tests/modules/planner/support/repairs.h"

namespace scanway::test {
namespace {

using planning::BodyMode;

class RepairAll : public testing::TestWithParam<RepairCase> {};

TEST_P(RepairAll, CostsWhatAFullSearchCosts) {
  for (std::uint64_t seed = 100; seed < 110; ++seed) expect_repairs_to_cost_what_full_searches_do(GetParam(), seed);
}

INSTANTIATE_TEST_SUITE_P(Modes, RepairAll,
                         testing::Values(RepairCase{"point", BodyMode::point, UnknownPolicy::never, 40, 60000},
                                         RepairCase{"point_price", BodyMode::point, UnknownPolicy::price, 40, 20000},
                                         RepairCase{"paper", BodyMode::paper, UnknownPolicy::free, 40, 14000},
                                         RepairCase{"footprint", BodyMode::footprint, UnknownPolicy::never, 50, 3000},
                                         RepairCase{"footprint_price", BodyMode::footprint, UnknownPolicy::price, 50,
                                                    3000}),
                         [](const auto& test) { return test.param.name; });

class NearTheRobotAll : public testing::TestWithParam<const char*> {};

TEST_P(NearTheRobotAll, AChangeCostsATwentiethOfANewSearch) {
  if (!has_moving_ai_maps()) GTEST_SKIP() << "no ../shared/data/grid_maps_movingai";
  const NearRobotEffort effort = change_near_robot(GetParam(), 5);
  EXPECT_GT(effort.changes, 80);
  EXPECT_LE(20 * (effort.expansions + effort.dropped), effort.expansions_anew);
}

INSTANTIATE_TEST_SUITE_P(Maps, NearTheRobotAll,
                         testing::Values("den520d", "AR0011SR", "16room_000", "random512-20-0", "maze512-8-0",
                                         "Berlin_0_256"));

}  // namespace
}  // namespace scanway::test
