#include <algorithm>

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "tests/modules/simulator/core/test_worlds.h"

namespace scanway::simulator::test {
namespace {

bool same(const RawSweep& a, const RawSweep& b) {
  return std::equal(a.readings.begin(), a.readings.end(), b.readings.begin(), b.readings.end(),
                    [](const BeamReading& x, const BeamReading& y) { return x == y; });
}

RawSweep street_sweep(std::uint64_t seed, int thin) {
  const World world = make_world("street", 4);
  const Robot robot = quick_robot();
  SweepConfig config;
  config.seed = seed;
  config.thin = thin;
  return simulate_lines(world, robot, stand_at(world, robot, places_on_route(world, 1)[0]).X_world_base, config);
}

TEST(Sweep, EveryNumberOfThreadsGivesTheSameBytes) {
  std::vector<RawSweep> sweeps;
  for (const int threads : {1, 2, 3}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
    sweeps.push_back(street_sweep(11, 1));
  }
  EXPECT_TRUE(same(sweeps[0], sweeps[1]));
  EXPECT_TRUE(same(sweeps[0], sweeps[2]));
  EXPECT_FALSE(same(sweeps[0], street_sweep(12, 1))) << "the seed counts";
}

TEST(Sweep, ThinnedIsAPartOfTheWhole) {
  const RawSweep whole = street_sweep(11, 1);
  for (const int thin : {2, 5}) {
    const RawSweep part = street_sweep(11, thin);
    EXPECT_EQ(part.lines, (whole.lines + thin - 1) / thin);
    EXPECT_EQ(part.beams, (whole.beams + thin - 1) / thin);
    for (int row = 0; row < part.lines; ++row) {
      for (int column = 0; column < part.beams; ++column) {
        ASSERT_TRUE(part.reading(row, column) == whole.reading(row * thin, column * thin)) << row << " " << column;
      }
    }
  }
}

TEST(Sweep, TheRobotSeesItsOwnBodyAndItsPointsLeaveItOut) {
  const Robot robot = quick_robot();
  SweepConfig config;
  const RawSweep raw = simulate_lines(Room{}.world(), robot, Pose::Identity(), config);
  const LabelledSweep all = points_of(raw, robot, true), clean = points_of(raw, robot);
  const auto on_robot = std::count(all.labels.begin(), all.labels.end(), Label::robot);
  EXPECT_GT(on_robot, raw.lines * raw.beams / 20);
  EXPECT_LT(on_robot, raw.lines * raw.beams / 3);
  EXPECT_EQ(std::count(clean.labels.begin(), clean.labels.end(), Label::robot), 0);
  // With it go mixed pixels at its edge and ground right beside it, and nothing farther away.
  std::size_t kept = 0;
  for (std::size_t i = 0; i < all.labels.size(); ++i) {
    const Eigen::Vector3f& p = all.sweep.cloud.points[i];
    if (kept < clean.labels.size() && p == clean.sweep.cloud.points[kept]) {
      ++kept;
      continue;
    }
    ASSERT_LT(std::fabs(p.x()), 0.2F + 0.081F);
    ASSERT_LT(std::fabs(p.y()), 0.205F + 0.081F);
    ASSERT_LT(p.z(), 0.5F);
  }
  EXPECT_EQ(kept, clean.labels.size());
  EXPECT_LT(all.labels.size() - kept - static_cast<std::size_t>(on_robot), all.labels.size() / 200);
}

TEST(Sweep, ARobotFileWithoutTheLasersPlaceSeesTheGroundAllTheSame) {
  Robot robot;  // Its mirror is in its plate, for the user to measure.
  robot.laser.beams = 96;
  robot.pan.speed_rad_s = radians(60);
  const LabelledSweep points =
      points_of(simulate_lines(Room{}.world(), robot, Pose::Identity(), SweepConfig{}), robot, true);
  EXPECT_EQ(std::count(points.labels.begin(), points.labels.end(), Label::robot), 0);
  EXPECT_GT(std::count(points.labels.begin(), points.labels.end(), Label::ground), 1000);
}

TEST(Sweep, PointsHaveTheirTimesAndLieOnTheWalls) {
  const Room room;
  const SimulatedSweep simulated = simulate_sweep(room.world(), {0.5, 1.0, 0.3}, quick_robot(), 8);
  const Sweep& sweep = simulated.sweep;
  ASSERT_EQ(sweep.time_offset_us.size(), sweep.cloud.size());
  ASSERT_EQ(sweep.cloud.intensity.size(), sweep.cloud.size());
  ASSERT_EQ(simulated.labels.size(), sweep.cloud.size());
  EXPECT_TRUE(std::is_sorted(sweep.time_offset_us.begin(), sweep.time_offset_us.end()));
  EXPECT_EQ(sweep.time_offset_us.back(), 0);
  EXPECT_NEAR(sweep.time_offset_us.front(), -12e6, 0.1e6);
  EXPECT_NEAR(sweep.origin.z(), 0.53, 1e-9);
  int far = 0;
  for (const Eigen::Vector3f& point : sweep.cloud.points) {
    const Eigen::Vector3d p = simulated.X_world_base * point.cast<double>();
    const Eigen::Array3d to_low = (p - room.low).cwiseAbs(), to_high = (p - room.high).cwiseAbs();
    far += std::min(to_low.minCoeff(), to_high.minCoeff()) > 0.05 ? 1 : 0;  // Five sigma.
  }
  EXPECT_LT(far, static_cast<int>(sweep.cloud.size() / 1000)) << "but for mixed pixels in corners";
}

TEST(Sweep, TheTrackerErrsAsItsModelSays) {
  const Robot robot;
  const Pose X = tilted_pose(0, 0, 0, 2.0);
  double heading_squares = 0, tilt_squares = 0, heading_most = 0, tilt_most = 0;
  constexpr int kSeeds = 2000;
  for (int seed = 0; seed < kSeeds; ++seed) {
    const Eigen::Matrix3d R = Tracker(robot.tracker, X, static_cast<std::uint64_t>(seed)).mean().toRotationMatrix();
    const double heading = heading_of(R * X.linear().transpose());
    const Eigen::Vector3d up = R * X.linear().transpose() * Eigen::Vector3d::UnitZ();
    const double tilt = std::hypot(up.x(), up.y());
    heading_squares += heading * heading;
    tilt_squares += tilt * tilt;
    heading_most = std::max(heading_most, std::fabs(heading));
    tilt_most = std::max(tilt_most, tilt);
  }
  EXPECT_NEAR(std::sqrt(heading_squares / kSeeds), radians(5) * 0.96, radians(0.3L));  // Cut off at two sigma.
  EXPECT_NEAR(std::sqrt(tilt_squares / kSeeds), radians(0.5L) * std::sqrt(2.0), radians(0.04L));
  EXPECT_LE(heading_most, radians(10.01L));
  EXPECT_LE(tilt_most, radians(1.5L) * std::sqrt(2.0) + 1e-6);
}

TEST(Sweep, TheTrackersErrorStaysTheSameDuringASweep) {
  const Tracker tracker(Robot{}.tracker, tilted_pose(0, 0, 0, 1), 5);
  for (const int index : {0, 1, 5000, 12000}) {
    const TrackerReading reading = tracker.read(index);
    EXPECT_LT(reading.R_world_base.angularDistance(tracker.mean()), radians(0.15L));
    EXPECT_GT(reading.R_world_base.angularDistance(tracker.mean()), 0.0);
    EXPECT_NEAR((reading.R_world_base * reading.accel).z(), 9.81, 0.1);
  }
}

}  // namespace
}  // namespace scanway::simulator::test
