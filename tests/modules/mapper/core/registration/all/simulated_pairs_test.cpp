#include <gtest/gtest.h>

#include "tests/bench/registration/real_pairs.h"
#include "tests/bench/registration/simulated/simulated_scans.h"

namespace scanway {
namespace {

using namespace bench;

constexpr double kRightMetres = 0.1, kRightRadians = 0.0087266;

struct SimulatedTally {
  int good = 0, good_right = 0, accepted = 0, wrong = 0;
};

SimulatedTally register_all(const SimulatedScans& s) {
  SimulatedTally tally;
  for (std::size_t target = 0; target < s.scans.size(); ++target) {
    for (std::size_t source = target + 1; source < s.scans.size(); ++source) {
      const RegistrationResult result = register_scans(s.scans[source], s.scans[target], s.prior(source, target), {});
      const PoseError error = error_of(result.T_target_source, s.T_target_source(source, target));
      const bool accepted = result.verdict == Verdict::accepted;
      const bool right = error.metres < kRightMetres && error.radians < kRightRadians;
      const bool good = s.overlap(source, target) >= 0.3;
      tally.good += good;
      tally.good_right += good && accepted && right;
      tally.accepted += accepted;
      tally.wrong += accepted && !right;
      EXPECT_TRUE(right || !accepted) << s.world << " " << source << " to " << target << ": " << error.metres << " m, "
                                      << error.radians << " rad, p " << result.probability << " " << result.reason;
    }
  }
  return tally;
}

TEST(SimulatedPairs, WhatIsAcceptedIsRightAndGoodPairsAreAccepted) {
  SimulatedTally all;
  for (const char* world : {"yard", "hall", "street", "rubble"}) {
    const SimulatedTally tally = register_all(simulate_scans(world, 101, {6, 40.0, 4}));
    all.good += tally.good;
    all.good_right += tally.good_right;
  }
  EXPECT_GE(all.good, 20);
  EXPECT_GE(100 * all.good_right, 97 * all.good) << all.good_right << " of " << all.good;
}

TEST(SimulatedPairs, CorridorAndFieldAreRefused) {
  for (const char* world : {"corridor", "field"}) {
    EXPECT_EQ(register_all(simulate_scans(world, 101, {5, 30.0, 4})).accepted, 0) << world;
  }
}

}  // namespace
}  // namespace scanway
