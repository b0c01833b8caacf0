#include <gtest/gtest.h>

#include <string>

#include "tests/modules/planner/support/body_trials.h"

namespace scanway::test {
namespace {

class BodyTrials : public testing::TestWithParam<TrialBody> {};

/// With those on the recorded maps and the other bodies', 10,000 problems.
TEST_P(BodyTrials, InSimulatedWorldsNoPoseOverlapsAnObstacle) {
  const TrialBody& body = GetParam();
  Random random(21);
  int ways = 0;
  for (const char* world : {"yard", "street", "hall", "car_park", "rubble", "trench", "kerbs", "flat"}) {
    for (std::uint64_t seed = 1; seed <= 2; ++seed) {
      ways += try_random_problems(truth_map(world, seed, body.robot, 0.1), body.robot, 180, random).ways;
    }
  }
  EXPECT_GT(ways, 300);
}

TEST_P(BodyTrials, OnRecordedMapsNoPoseOverlapsAnObstacle) {
  const TrialBody& body = GetParam();
  if (std::string(body.name) == "car") GTEST_SKIP() << "nothing there is made for cars";
  Random random(22);
  int ways = 0;
  for (const char* name : {"depot", "warehouse"}) {
    const TestMap map = recorded_map(name);
    if (map.map.tiles.empty()) GTEST_SKIP() << "no ../shared/data/occupancy_maps";
    ways += try_random_problems(map, body.robot, 340, random).ways;
  }
  EXPECT_GT(ways, 100);
}

TEST_P(BodyTrials, FindsAWayWhereverAnExhaustiveSearchDoes) {
  const TrialBody& body = GetParam();
  Random random(23);
  const Tally tally = try_against_exhaustive_search(body, std::string(body.name) == "car" ? 100 : 200, random);
  EXPECT_GT(tally.ways, 10);
  EXPECT_GT(tally.none, 10);
}

INSTANTIATE_TEST_SUITE_P(Bodies, BodyTrials, testing::ValuesIn(trial_bodies()),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace scanway::test
