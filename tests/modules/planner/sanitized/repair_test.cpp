#include <gtest/gtest.h>

#include "tests/modules/planner/support/repairs.h"

namespace scanway::test {
namespace {

using planning::BodyMode;

class Repair : public testing::TestWithParam<RepairCase> {};

TEST_P(Repair, CostsWhatAFullSearchCosts) { expect_repairs_to_cost_what_full_searches_do(GetParam(), 7); }

INSTANTIATE_TEST_SUITE_P(Modes, Repair,
                         testing::Values(RepairCase{"point", BodyMode::point, UnknownPolicy::never, 40, 5000},
                                         RepairCase{"point_price", BodyMode::point, UnknownPolicy::price, 40, 2000},
                                         RepairCase{"paper", BodyMode::paper, UnknownPolicy::free, 40, 1500},
                                         RepairCase{"footprint", BodyMode::footprint, UnknownPolicy::never, 50, 750},
                                         RepairCase{"footprint_price", BodyMode::footprint, UnknownPolicy::price, 50,
                                                    750}),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace scanway::test
