// What is said of a robot and of things that do not stand still while a sweep is taken.
#include "modules/mapper/core/movement/movement.h"

#include <gtest/gtest.h>

#include "common/random/random.h"
#include "modules/mapper/core/movement/change_point.h"
#include "tests/modules/mapper/core/movement/simulated_pair.h"

namespace scanway {
namespace {

using testing::SimulatedPair;

/// Residuals of planes in all directions, seen by a sensor that moved by `by` before slot `when`.
std::vector<MotionEvidence> slots_of(const Vector6& by, std::size_t when, std::uint64_t seed) {
  Random random(seed);
  std::vector<MotionEvidence> slots(40);
  for (std::size_t slot = 0; slot < slots.size(); ++slot) {
    for (int i = 0; i < 30; ++i) {
      const Eigen::Vector3d n = Eigen::Vector3d(random.normal(), random.normal(), random.normal()).normalized();
      const Eigen::Vector3d p(5.0 * random.normal(), 5.0 * random.normal(), 2.0 * random.normal());
      Vector6 J;
      J << p.cross(n), n;
      const double moved = slot >= when ? -J.dot(by) : 0.0;
      slots[slot].add(J, moved + 0.01 * random.normal(), 1e4);
    }
  }
  return slots;
}

TEST(ChangePoint, IsFoundWithItsMotionAndItsDeviation) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Vector6 by;
    by << 0.0, 0.0, 0.004, 0.03, -0.02, 0.01;
    const std::size_t when = 5 + seed % 30;
    const ChangePoint change = find_change(slots_of(by, when, seed), 20);
    EXPECT_NEAR(static_cast<double>(change.slot), static_cast<double>(when), 1.0) << seed;
    const Vector6 error = change.after - change.before - by;
    EXPECT_LT(error.dot(change.covariance.inverse() * error), 30.0) << seed;
  }
}

TEST(ChangePoint, OfTooLittleNothingIsSaid) {
  EXPECT_EQ(find_change({}, 10).slot, 0u);
  EXPECT_EQ(find_change(slots_of(Vector6::Zero(), 0, 1), 1000).slot, 0u);
}

TEST(Movement, WithoutTimesNothingIsKnownOfTheRobot) {
  const SimulatedPair pair("hall", 3, 6);
  Sweep sweep = pair.disturbed({});
  EXPECT_TRUE(DirectionTimes(sweep).known());
  sweep.time_offset_us.clear();
  EXPECT_FALSE(DirectionTimes(sweep).known());
  sweep.time_offset_us.assign(sweep.cloud.size(), 0);
  EXPECT_FALSE(DirectionTimes(sweep).known());
}

TEST(Movement, EachDirectionWasSeenAtItsTime) {
  const SimulatedPair pair("hall", 3, 6);
  const Sweep sweep = pair.disturbed({});
  const DirectionTimes times(sweep);
  EXPECT_NEAR(times.duration_s(), 120.0, 1.0);
  for (const double turn : {-3.0, -1.5, 0.5, 2.9}) {  // The pan begins behind the robot, at half a turn.
    const auto direction = (rotation_about_z(turn) * Eigen::Vector3d(4.0, 0.0, 0.1)).cast<float>();
    ASSERT_TRUE(times.at(direction)) << turn;
    EXPECT_NEAR(*times.at(direction), 60.0 + turn / 0.05236, 1.0) << turn;
  }
  EXPECT_FALSE(times.at({0.1f, 0.0f, 3.0f})) << "the zenith is seen all the time";
  EXPECT_FALSE(times.at({-4.0f, 0.0f, 0.0f})) << "the seam is seen at the begin and at the end";
}

TEST(Movement, WhatStandsStillIsSaidToStandStill) {
  const Movement movement = SimulatedPair("hall", 3, 4).movement({});
  EXPECT_TRUE(movement.robot.known);
  EXPECT_FALSE(movement.robot.moved) << movement.robot.shift_m << " m";
  EXPECT_FALSE(movement.scene.moved());
  EXPECT_EQ(said_of(movement), "");
}

TEST(Movement, ARobotThatIsPushedIsSeenAndPeopleToo) {
  const SimulatedPair pair("hall", 3, 4);
  const Movement pushed = pair.movement({{0.04, -0.03, 0.0}, 0.0, 50.0, 0});
  EXPECT_TRUE(pushed.robot.moved);
  EXPECT_FALSE(breaks_sweep(pushed.robot));
  EXPECT_NEAR(pushed.robot.shift_m, 0.05, 0.015);
  EXPECT_NEAR(pushed.robot.after_s, 50.0, 10.0);
  EXPECT_NE(said_of(pushed).find("The robot moved during the sweep"), std::string::npos);

  const Movement crowd = pair.movement({{}, 0.0, 0.0, 3});
  EXPECT_FALSE(crowd.robot.moved) << crowd.robot.shift_m << " m";
  EXPECT_GE(crowd.scene.came, 1u);
  EXPECT_GT(crowd.scene.share, 0.0);
  EXPECT_LT(crowd.scene.nearest_m, 12.0);
  EXPECT_NE(said_of(crowd).find("Things moved"), std::string::npos);
}

TEST(Movement, ARobotThatIsPushedFarHasNoOnePose) {
  const Movement movement = SimulatedPair("hall", 4, 4).movement({{0.3, 0.1, 0.0}, 0.02, 70.0, 0});
  EXPECT_TRUE(breaks_sweep(movement.robot));
  EXPECT_NEAR(movement.robot.shift_m, 0.316, 0.03);
  EXPECT_NEAR(movement.robot.turn_rad, 0.02, 0.004);
}

}  // namespace
}  // namespace scanway
