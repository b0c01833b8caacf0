// Three full sweeps of each world at their true poses: what the map must show of the truth.
#include <cstdio>

#include <gtest/gtest.h>

#include "tests/modules/mapper/core/costmap/truth/judged_map.h"

namespace scanway::testing {
namespace {

class CostMapOfWorld : public ::testing::TestWithParam<const char*> {};

TEST_P(CostMapOfWorld, IsTheTruthWhereTwoSweepsSawTheGround) {
  const tools::MapComparison counts = judge(take_sweeps(GetParam(), 31, {})).counts;
  const tools::CellCounts& seen = counts.two;
  const auto number = [](std::int64_t n) { return static_cast<long long>(n); };
  std::printf("%s: free %lld, lost %lld; obstacles %lld, called free %lld; drop-offs %lld, not marked %lld\n",
              GetParam(), number(seen.free), number(seen.free_lost()), number(seen.occupied),
              number(seen.occupied_called_free), number(seen.drop_offs), number(seen.drop_offs_unmarked));
  ASSERT_GT(seen.free, 1'000'000);
  // What a robot needs that is to be trusted; docs/benchmarks.md says which worlds are not there yet, and why.
  EXPECT_LE(seen.free_lost(), 0.01 * static_cast<double>(seen.free));
  EXPECT_LE(seen.occupied_called_free, 0.001 * static_cast<double>(seen.occupied));
  EXPECT_EQ(seen.drop_offs_unmarked, 0);
}

INSTANTIATE_TEST_SUITE_P(Worlds, CostMapOfWorld,
                         ::testing::Values("flat", "slope", "ramp", "kerbs", "rubble", "trench", "car_park"));

}  // namespace
}  // namespace scanway::testing
