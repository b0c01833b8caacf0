#include <cmath>

#include <gtest/gtest.h>

#include "tests/modules/simulator/core/test_worlds.h"

namespace scanway::simulator::test {
namespace {

using Eigen::AngleAxisd;
using Eigen::Vector3d;

constexpr double kDegree = M_PI / 180.0;

/// Where a beam leaves and where it goes, written down from the data sheets: a mirror that turns at 25 Hz from -95 to
/// +95 degrees, on a pan that turns at `pan_speed` degrees a second from -180.
struct Beam {
  Vector3d origin, direction;
  double pan = 0.0, time_s = 0.0;
};

Beam beam_by_formula(const Pose& X_world_base, const Robot& robot, double line_begins_s, int beam) {
  const double step_deg = 190.0 / (robot.laser.beams - 1);
  Beam out;
  out.time_s = line_begins_s + beam * step_deg / 360.0 / 25.0;
  out.pan = -M_PI + robot.pan.speed_rad_s * out.time_s;
  const double angle = (-95.0 + beam * step_deg) * kDegree;
  const Eigen::Matrix3d turn = AngleAxisd(out.pan, Vector3d::UnitZ()).toRotationMatrix();
  // The laser lies on its side: its angle is an elevation. The mirror is 0.03 m ahead of the pan axis, 0.53 m up.
  out.origin = X_world_base * Vector3d(turn * Vector3d(0.03, 0, 0) + Vector3d(0, 0, 0.15 + 0.22 + 0.16));
  out.direction = X_world_base.linear() * (turn * Vector3d(std::cos(angle), 0, std::sin(angle)));
  return out;
}

TEST(Wall, RangesAreThoseOfTheFormula) {
  const Room room;
  Robot robot = quick_robot();
  robot.laser.range_sigma_m = 0.0;
  const Pose X = tilted_pose(-0.7, 1.2, 0.05, 0.4);
  SweepConfig config;
  config.seed = 3;
  const RawSweep raw = simulate_lines(room.world(), robot, X, config);
  int checked = 0, on_robot = 0;
  for (int row = 0; row < raw.lines; ++row) {
    const double begins_s = 1e-6 * static_cast<double>(raw.pattern.line_utime(row) - raw.pattern.start());
    for (int column = 0; column < raw.beams; ++column) {
      const Beam beam = beam_by_formula(X, robot, begins_s, column);
      if (beam.time_s > 12.0) continue;  // The pan stands.
      const BeamReading& reading = raw.reading(row, column);
      if (reading.label == Label::robot) {
        ++on_robot;
        continue;
      }
      const auto [range, to_next] = room.distance(beam.origin, beam.direction);
      if (to_next < 0.15 * range) continue;  // Its footprint may lie on two walls.
      ASSERT_NEAR(reading.range_count * raw.range_scale_m, range, raw.range_scale_m / 2 + 1e-4)
          << "line " << row << " beam " << column;
      ++checked;
    }
  }
  EXPECT_GT(checked, raw.lines * raw.beams / 2);
  EXPECT_GT(on_robot, raw.lines);
}

TEST(Wall, BeamTimesAndPanAnglesAreThoseOfTheFormula) {
  const Robot robot = simulated_robot();
  const ScanPattern pattern(robot, 1000, 7);
  EXPECT_EQ(pattern.lines(), 3000);
  EXPECT_EQ(pattern.beams(), 1141);
  EXPECT_EQ(pattern.end() - pattern.start(), 120 * kMicrosecondsPerSecond);
  const Pose X = tilted_pose(1, 2, 3, 0.3);
  for (const int line : {0, 1, 17, 1500, 2998}) {
    const double begins_s = 1e-6 * static_cast<double>(pattern.line_utime(line) - pattern.start());
    EXPECT_NEAR(begins_s, line * 0.04, 0.0402);
    for (const int beam : {0, 1, 570, 1140}) {
      const Beam expected = beam_by_formula(X, robot, begins_s, beam);
      EXPECT_NEAR(pattern.beam_time_us(line, beam), expected.time_s * 1e6, 1e-3);
      const double pan = pattern.pan_angle(pattern.beam_time_us(line, beam));
      EXPECT_NEAR(pan, expected.pan, 1e-9);
      const Pose X_world_laser = X * pattern.X_base_laser(pan);
      const double angle = pattern.angle(beam);
      EXPECT_LT((X_world_laser.translation() - expected.origin).norm(), 1e-9);
      EXPECT_LT((X_world_laser.linear() * Vector3d(std::cos(angle), std::sin(angle), 0) - expected.direction).norm(),
                1e-9);
    }
  }
}

TEST(Wall, TheMirrorGoesItsOwnWay) {
  const Robot robot = simulated_robot();
  const ScanPattern one(robot, 0, 1), other(robot, 0, 2);
  EXPECT_NE(one.line_utime(0), other.line_utime(0));
  Utime least = 1'000'000, most = 0;
  for (int line = 1; line < one.lines(); ++line) {
    const Utime period = one.line_utime(line) - one.line_utime(line - 1);
    least = std::min(least, period);
    most = std::max(most, period);
  }
  EXPECT_GE(least, 39'700);
  EXPECT_LT(least, 39'950);
  EXPECT_GT(most, 40'050);
  EXPECT_LE(most, 40'400);
}

TEST(Wall, NoiseIsThatOfTheRobotFile) {
  const Room room;
  Robot robot = quick_robot();
  robot.laser.beams = 381;
  const World world = room.world();
  const Pose X = tilted_pose(0, 1, 0, 0);
  SweepConfig config;
  config.seed = 5;
  const RawSweep noisy = simulate_lines(world, robot, X, config);
  robot.laser.range_sigma_m = 0.0;
  const RawSweep clean = simulate_lines(world, robot, X, config);
  double sum = 0, squares = 0;
  int n = 0, beyond_20_mm = 0;
  for (std::size_t i = 0; i < noisy.readings.size(); ++i) {
    if (clean.readings[i].label == Label::robot || clean.readings[i].range_count == 0) continue;
    const double error = (noisy.readings[i].range_count - clean.readings[i].range_count) * noisy.range_scale_m;
    sum += error;
    squares += error * error;
    beyond_20_mm += std::fabs(error) > 0.02 ? 1 : 0;
    ++n;
  }
  ASSERT_GT(n, 80'000);
  EXPECT_NEAR(sum / n, 0.0, 5 * 0.01 / std::sqrt(n));
  // Two roundings to 2 mm add 2 * 2^2 / 12 mm^2.
  EXPECT_NEAR(std::sqrt(squares / n), std::sqrt(1e-4 + 2 * 4e-6 / 12), 1e-4);
  // Errors come in steps of 2 mm: more than 20 mm is 22 mm and up, which rounding makes of 21 mm and up.
  EXPECT_NEAR(static_cast<double>(beyond_20_mm) / n, std::erfc(2.1 / std::sqrt(2.0)), 0.003);
}

}  // namespace
}  // namespace scanway::simulator::test
