#include <gtest/gtest.h>

#include "tests/bench/mapping/yard/yard.h"
#include "tests/modules/mapper/core/octomap/support/reference.h"

namespace scanway {
namespace {

TEST(Yard, ThreeFullSweepsInARowAreThoseOfLiboctomap) {
  std::vector<MapPoints> sweeps;
  for (int i = 0; i < 3; ++i) sweeps.push_back(bench::yard_sweep(i, bench::kFullRound, bench::kFullUp));
  const OccupancyTreeConfig config{0.05, -1.0, false};
  EXPECT_TRUE(files_of_ours(sweeps, config) == files_of_liboctomap(sweeps, config));
}

}  // namespace
}  // namespace scanway
