#include "common/robot/robot.h"

#include <cmath>

#include <gtest/gtest.h>

namespace scanway {
namespace {

TEST(Robot, RadiiOfTheEraMobiAreThoseOfThePaper) {
  EXPECT_NEAR(Robot{}.circumscribed_radius_m(), 0.2864, 5e-5);
  EXPECT_DOUBLE_EQ(Robot{}.inscribed_radius_m(), 0.20);
}

TEST(Robot, RadiiOfABodyWhoseCentreIsNotInTheMiddle) {
  Robot robot;
  robot.body.footprint = {{3, 0.5}, {-1, 0.5}, {-1, -0.75}, {3, -0.75}};
  EXPECT_DOUBLE_EQ(robot.inscribed_radius_m(), 0.5);
  EXPECT_DOUBLE_EQ(robot.circumscribed_radius_m(), std::hypot(3, 0.75));
  robot.body.footprint = {{0, 1}, {-1, 0}, {0, -1}, {1, 0}};
  EXPECT_DOUBLE_EQ(robot.inscribed_radius_m(), std::sqrt(0.5));
}

TEST(Robot, ARoundMountTurnsYawFirst) {
  const Mount mount{{1, 2, 3}, {0.3, -0.4, 2.5}};
  const Eigen::Matrix3d expected =
      (Eigen::AngleAxisd(2.5, Eigen::Vector3d::UnitZ()) * Eigen::AngleAxisd(-0.4, Eigen::Vector3d::UnitY()) *
       Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitX()))
          .toRotationMatrix();
  EXPECT_LT((mount.pose().linear() - expected).norm(), 1e-14);
  EXPECT_EQ(mount.pose().translation(), Eigen::Vector3d(1, 2, 3));
}

TEST(Robot, TheLaserScansAVerticalPlane) {
  const Eigen::Matrix3d R = Robot{}.mounts.pan_laser.pose().linear();
  EXPECT_LT((R * Eigen::Vector3d::UnitY() - Eigen::Vector3d::UnitZ()).norm(), 1e-15);
  EXPECT_LT((R * Eigen::Vector3d::UnitX() - Eigen::Vector3d::UnitX()).norm(), 1e-15);
}

}  // namespace
}  // namespace scanway
