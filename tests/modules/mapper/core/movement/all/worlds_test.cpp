// Standing still, pushed, and among people, in many worlds.
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/modules/mapper/core/movement/simulated_pair.h"

namespace scanway {
namespace {

using testing::SimulatedPair;

constexpr int kThin = 3;

class Worlds : public ::testing::TestWithParam<const char*> {};

TEST_P(Worlds, NoFalseAlarmAndNoMovementMissed) {
  for (std::uint64_t seed = 11; seed <= 12; ++seed) {
    const SimulatedPair pair(GetParam(), seed, kThin);
    const auto movement = [&](const testing::Disturbance& by) -> Movement {
      try {
        return pair.movement(by);
      } catch (const std::runtime_error& refused) {
        ADD_FAILURE() << seed << ": " << refused.what();
        return {};
      }
    };
    const Movement still = movement({});
    EXPECT_FALSE(still.robot.moved) << seed << said_of(still);
    EXPECT_FALSE(still.scene.moved()) << seed << said_of(still);
    const Movement people = movement({{}, 0.0, 0.0, 4});
    EXPECT_FALSE(people.robot.moved) << seed << said_of(people);
    EXPECT_TRUE(people.scene.moved()) << seed;
    const Movement pushed = movement({{0.15, 0.1, 0.0}, 0.01, 45.0, 0});
    EXPECT_TRUE(pushed.robot.moved) << seed;
    EXPECT_NEAR(pushed.robot.shift_m, 0.18, 0.05) << seed;
    EXPECT_NEAR(pushed.robot.after_s, 45.0, 12.0) << seed;
  }
}

INSTANTIATE_TEST_SUITE_P(Simulated, Worlds, ::testing::Values("street", "yard", "hall", "rubble", "kerbs", "trench"));

}  // namespace
}  // namespace scanway
