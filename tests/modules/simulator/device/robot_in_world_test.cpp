#include "modules/simulator/device/robot/robot_in_world.h"

#include <cmath>

#include "tests/modules/simulator/device/robot_in_room.h"
#include "tests/modules/simulator/device/shared_facts.h"

namespace scanway::test {
namespace {

constexpr double kBeam_us = 40'000.0 / 2160.0;

/// How many of the scan's ranges are a wall's, and how many are not; beams at corners and on the robot do not count.
/// `start`: of the first beam, on the robot's clock; `beam_us`: from one to the next, on the same.
std::pair<int, int> walls_in(const sick::Scan& scan, const RobotInWorld& simulated, const Robot& robot,
                             const simulator::test::Room& room, double start, double beam_us) {
  int right = 0, wrong = 0;
  const ScanPattern frames(robot, 0, 0);
  const sick::ScanChannel& channel = *scan.channel("DIST1");
  for (std::size_t i = 0; i < channel.counts.size(); ++i) {
    const double range = channel.counts[i] * static_cast<double>(channel.scale) * 1e-3;
    if (range < 1.0) continue;
    const double a = radians(1) * (-5.0 + static_cast<double>(i) / 6.0);
    const auto time = static_cast<Utime>(start + static_cast<double>(i) * beam_us);
    const Pose X_world_laser = simulated.X_world_base() * frames.X_base_laser(simulated.pan_angle(time));
    const Eigen::Vector3d direction = X_world_laser.linear() * Eigen::Vector3d(std::sin(a), -std::cos(a), 0.0);
    const auto [expected, to_next] = room.distance(X_world_laser.translation(), direction);
    if (to_next < 0.5) continue;
    ++(std::fabs(range - expected) < 6 * robot.laser.range_sigma_m ? right : wrong);
  }
  return {right, wrong};
}

TEST_F(RobotInRoom, TheScansAreTheWallsWhileTheMirrorAndThePanTurn) {
  using schunk::Axis;
  ASSERT_TRUE(run_until([&] { return pan_tilt.core().pan().phase() == Axis::Phase::ready && !scans.empty(); }));
  scans.clear();
  EXPECT_EQ(pan_tilt.core().turn_pan(radians(60), pan_tilt.now()), "");
  ASSERT_TRUE(run_until([&] { return scans.size() >= 32; }));
  EXPECT_GT(simulated.pan_angle(now()), radians(30));
  int right = 0, wrong = 0;
  for (const sick::Scan& scan : scans) {
    const auto [walls, others] = walls_in(scan, simulated, robot, room, scan.start_time_us, kBeam_us);
    right += walls;
    wrong += others;
  }
  EXPECT_GT(right, 1000);  // Of 8 turns of the mirror that see, every fourth beam.
  EXPECT_LT(wrong, right / 200);
  pan_tilt.core().stop(pan_tilt.now());
  ASSERT_TRUE(run_until([&] { return pan_tilt.core().pan().state()->velocity == 0.0; }));
}

TEST_F(RobotInRoom, AtFiveTimesTheSpeedTheScansAreTheWallsByTheHostsClock) {
  using schunk::Axis;
  speed = 5.0;
  simulated.tell_host_time(speed);
  ASSERT_TRUE(run_until([&] { return pan_tilt.core().pan().phase() == Axis::Phase::ready && !scans.empty(); }));
  EXPECT_EQ(pan_tilt.core().turn_pan(radians(20), pan_tilt.now()), "");
  ASSERT_TRUE(run_until([&] { return pan_tilt.core().pan().state()->position > radians(40); }));
  scans.clear();
  utimes.clear();
  ASSERT_TRUE(run_until([&] { return scans.size() >= 64; }));
  int right = 0, wrong = 0;
  for (std::size_t i = 0; i < scans.size(); ++i) {
    const double beam_us = 1e8 / scans[i].scan_frequency / 2160.0 * speed;
    const auto [walls, others] =
        walls_in(scans[i], simulated, robot, room, static_cast<double>(utimes[i] - host_began) * speed, beam_us);
    right += walls;
    wrong += others;
  }
  EXPECT_GT(right, 2000);
  // Most beams meet the floor, the ceiling or a wall end on. By clocks that run five times as fast, a tenth is wrong.
  EXPECT_LT(wrong, right / 30) << right;
  pan_tilt.core().stop(pan_tilt.now());
  ASSERT_TRUE(run_until([&] { return pan_tilt.core().pan().state()->velocity == 0.0; }));
}

TEST_F(RobotInRoom, StandsWhereItsWheelsHaveBroughtIt) {
  ASSERT_TRUE(run_until([&] { return base.core().ready(); }));
  const Pose X_before = simulated.X_world_base();
  ASSERT_TRUE(run_until([&] {
    base.core().drive(0.4, 0.0, base.now());
    return base.core().pose().x_m > 0.3;
  }));
  base.core().stop(base.now());
  ASSERT_TRUE(run_until([&] { return base.core().pose().speed_m_s == 0.0; }));
  run_until([&, settled = now() + 200'000] { return now() > settled; });
  EXPECT_EQ(simulated.obstacle(), "");
  const Pose X_before_now = X_before.inverse() * simulated.X_world_base();
  EXPECT_NEAR(X_before_now.translation().x(), base.core().pose().x_m, 0.005);
  EXPECT_NEAR(X_before_now.translation().y(), 0.0, 0.01);
  EXPECT_NEAR(simulated.X_world_base().linear()(2, 2), 1.0, 1e-9) << "on the level floor again";
}

}  // namespace
}  // namespace scanway::test
