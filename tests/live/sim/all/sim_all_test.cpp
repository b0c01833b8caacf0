// launch/sim as a person starts it: three full sweeps at 20 times real speed.
#include <cstdio>

#include <gtest/gtest.h>

#include "tests/live/sim/support/simulated_run.h"

namespace scanway::test {
namespace {

TEST(LaunchSimAll, ThreeFullSweepsAreOneMapAndTheLogVerifies) {
  const SimulatedRun run({"--world", "yard", "--seed", "1", "--places", "3", "--speed", "20"});
  ASSERT_EQ(run.said().status, 0) << run.told();
  std::puts(run.said().out.c_str());
  EXPECT_EQ(run.pictures().size(), 3U);
  const auto truth = run.truth();
  ASSERT_EQ(truth["sweeps"].size(), 3U);
  for (const auto& sweep : truth["sweeps"]) {
    ASSERT_EQ(sweep["verdict"], "accepted");
    EXPECT_LT(sweep["to_previous_error_m"], 0.05);
    EXPECT_LT(sweep["to_previous_error_deg"], 0.3);
  }
  const auto& cells = truth["cost_map"]["seen_twice_or_more"];
  EXPECT_GT(cells["free"], 100'000);
  EXPECT_GT(cells["occupied"], 1'000);
  const CommandResult verified = run.verify();
  EXPECT_EQ(verified.status, 0) << verified.out << verified.err;
}

}  // namespace
}  // namespace scanway::test
