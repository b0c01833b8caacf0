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
  // The aim is 1 % lost, 0.1 % called free and every drop-off marked; docs/benchmarks.md says how far it is. These
  // bounds hold what stands.
  EXPECT_LE(seen.free_called_occupied, 0.005 * static_cast<double>(seen.free));
  EXPECT_LE(seen.free_lost(), 0.06 * static_cast<double>(seen.free));
  EXPECT_LE(seen.occupied_called_free, 0.06 * static_cast<double>(seen.occupied));
}

INSTANTIATE_TEST_SUITE_P(Worlds, CostMapOfWorld,
                         ::testing::Values("flat", "slope", "ramp", "kerbs", "rubble", "trench", "car_park"));

}  // namespace
}  // namespace scanway::testing
