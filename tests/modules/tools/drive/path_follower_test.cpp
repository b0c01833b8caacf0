#include "modules/tools/drive/path_follower.h"

#include <cmath>
#include <deque>

#include <gtest/gtest.h>

#include "common/math/angle.h"
#include "common/random/random.h"

namespace scanway::tools {
namespace {

using Eigen::Vector2d;

/// A robot with two wheels that does what it is told some steps later.
struct LateRobot {
  Vector2d at{0.0, 0.0};
  double heading = 0.0;
  std::deque<Motion> told;

  void step(const Motion& motion, double seconds, std::size_t late) {
    told.push_back(motion);
    if (told.size() <= late) return;
    const Motion now = told.front();
    told.pop_front();
    heading += now.turn_rad_s * seconds / 2;
    at += now.forward_m_s * seconds * Vector2d(std::cos(heading), std::sin(heading));
    heading += now.turn_rad_s * seconds / 2;
  }
};

/// A way as a planner gives it: legs of some metres that bend by less than a right angle.
std::vector<Vector2d> random_path(Random& random) {
  std::vector<Vector2d> path{{0.0, 0.0}};
  double heading = random.uniform() * 6.28;
  for (int leg = 0; leg < 4; ++leg) {
    heading += (random.uniform() - 0.5) * radians(160);
    const double length = 0.5 + 3.0 * random.uniform();
    const Vector2d from = path.back();
    for (double along = 0.02; along < length; along += 0.02) {
      path.push_back(from + along * Vector2d(std::cos(heading), std::sin(heading)));
    }
  }
  return path;
}

struct Drive {
  double farthest_m = 0.0;
  Vector2d end;
  bool lost = false;
  int steps = 0;
};

Drive drive(const std::vector<Vector2d>& path, double heading, double speed_m_s, std::size_t late) {
  constexpr double kStep_m = 0.02;
  FollowerLimits limits;
  limits.speed_m_s = speed_m_s;
  PathFollower follower(path, limits);
  LateRobot robot;
  robot.heading = heading;
  Drive drive;
  for (; drive.steps < 20'000; ++drive.steps) {
    const auto motion = follower.next(robot.at, robot.heading);
    drive.farthest_m = std::max(drive.farthest_m, follower.off_path_m());
    if (!motion) break;
    EXPECT_LE(std::fabs(motion->forward_m_s), speed_m_s * (1 + 1e-12));
    robot.step(*motion, kStep_m / speed_m_s, late);
  }
  drive.end = robot.at;
  drive.lost = follower.lost();
  return drive;
}

TEST(PathFollower, KeepsToRandomPathsAndArrivesThoughTheRobotIsLate) {
  Random random(3);
  for (int i = 0; i < 300; ++i) {
    const auto path = random_path(random);
    const Drive driven = drive(path, random.uniform() * 6.28, 0.3, random.below(6));
    ASSERT_FALSE(driven.lost) << i;
    ASSERT_LT(driven.steps, 20'000) << i << ": never arrives";
    ASSERT_LT((driven.end - path.back()).norm(), 0.15) << i;
    ASSERT_LT(driven.farthest_m, 0.3) << i;
  }
}

TEST(PathFollower, DrivesTheSameWayAtEverySpeed) {
  Random random(4);
  const auto path = random_path(random);
  const Drive slow = drive(path, 1.0, 0.03, 2), fast = drive(path, 1.0, 0.6, 2);
  EXPECT_EQ(slow.steps, fast.steps);
  EXPECT_NEAR((slow.end - fast.end).norm(), 0.0, 1e-9);
}

TEST(PathFollower, TurnsInPlaceToAPathBehindIt) {
  PathFollower follower({{0.0, 0.0}, {-2.0, 0.0}}, {});
  const auto motion = follower.next({0.0, 0.0}, 0.1);
  ASSERT_TRUE(motion);
  EXPECT_EQ(motion->forward_m_s, 0.0);
  EXPECT_GT(motion->turn_rad_s, 0.0) << "the shorter way";
}

TEST(PathFollower, IsLostFarFromThePath) {
  PathFollower follower({{0.0, 0.0}, {2.0, 0.0}}, {});
  EXPECT_TRUE(follower.next({0.1, 0.2}, 0.0));
  EXPECT_FALSE(follower.next({0.5, 0.7}, 0.0));
  EXPECT_TRUE(follower.lost());
}

TEST(PathFollower, HasArrivedOnAPathOfOnePoint) {
  PathFollower follower({{1.0, 1.0}}, {});
  EXPECT_FALSE(follower.next({1.02, 1.0}, 0.0));
  EXPECT_FALSE(follower.lost());
}

}  // namespace
}  // namespace scanway::tools
