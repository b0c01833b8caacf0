#include "modules/mapper/core/assembly/assembly.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "common/random/random.h"
#include "tests/modules/simulator/core/test_worlds.h"

namespace scanway {
namespace {

using simulator::RawSweep;
using simulator::SweepConfig;
using simulator::test::Room;

/// A big room whose walls are seen at all angles of incidence.
Room big_room() { return {{-18.0, -15.0, 0.0}, {16.0, 20.0, 9.0}}; }

std::vector<ScanLine> lines_of(const RawSweep& raw) {
  std::vector<ScanLine> lines;
  for (int row = 0; row < raw.lines; ++row) {
    ScanLine line;
    line.number = 100 + row;
    line.utime = raw.pattern.line_utime(raw.line_of(row));
    line.beam_period_us = raw.pattern.beam_period_us() * raw.thin;
    line.start_angle_rad = radians(-5);  // As the scanner counts.
    line.angle_step_rad = radians(190) / (raw.pattern.beams() - 1) * raw.thin;
    line.range_scale_m = raw.range_scale_m;
    for (int column = 0; column < raw.beams; ++column) {
      line.range_counts.push_back(raw.reading(row, column).range_count);
      line.rssi_counts.push_back(raw.reading(row, column).rssi_count);
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

/// All that the bridges tell of the sweep.
AssemblyInput input_of(const RawSweep& raw, const Robot& robot, const Pose& X_world_base) {
  AssemblyInput input;
  input.sweep = 4;
  input.started = raw.pattern.start();
  input.ended = raw.pattern.end();
  input.lines = lines_of(raw);
  const simulator::Tracker tracker(robot.tracker, X_world_base, 1);
  for (Utime utime = input.started - 500'000; utime < input.ended + 500'000; utime += 20'000) {
    const auto pan = static_cast<float>(raw.pattern.pan_angle(static_cast<double>(utime - input.started)));
    input.angles.push_back({utime, pan, raw.pattern.tilt()});
  }
  int index = 0;
  for (Utime utime = input.started - 500'000; utime < input.ended + 500'000; utime += 10'000) {
    input.orientations.push_back({utime, tracker.read(index++).R_world_base});
  }
  return input;
}

struct Thickness {
  double measured_m = 0.0, by_noise_m = 0.0;
  int points = 0;
};

/// Root mean square distance of the points from the room's walls, and what noise along the beams and rounded counts
/// make of it.
Thickness thickness_of(const Sweep& sweep, const Pose& X_world_base, const Room& room, const Robot& robot) {
  Thickness result;
  double squares = 0, expected = 0;
  const double along_beam = robot.laser.range_sigma_m * robot.laser.range_sigma_m + 0.002 * 0.002 / 12;
  const Eigen::Vector3d origin = X_world_base * sweep.origin;
  for (const Eigen::Vector3f& point : sweep.cloud.points) {
    const Eigen::Vector3d p = X_world_base * point.cast<double>(), beam = (p - origin).normalized();
    for (int axis = 0; axis < 2; ++axis) {  // The four walls.
      const double off = std::min(std::fabs(p[axis] - room.low[axis]), std::fabs(p[axis] - room.high[axis]));
      double next = 1e9;
      for (int other = 0; other < 3; ++other) {
        if (other == axis) continue;
        next = std::min({next, std::fabs(p[other] - room.low[other]), std::fabs(p[other] - room.high[other])});
      }
      if (off > 0.5 || next < 0.6) continue;  // Another wall, or a corner.
      squares += off * off;
      expected += beam[axis] * beam[axis] * along_beam;
      ++result.points;
    }
  }
  result.measured_m = std::sqrt(squares / result.points);
  result.by_noise_m = std::sqrt(expected / result.points);
  return result;
}

TEST(Assembly, WallsAreAsThickAsTheNoiseMakesThem) {
  const Room room = big_room();
  const simulator::World world = room.world();
  for (const double speed_deg_s : {3.0, 12.0}) {
    Robot robot = simulator::simulated_robot();
    robot.pan.speed_rad_s = speed_deg_s * radians(1);
    const Pose X = simulator::test::tilted_pose(-2, 1, 0.02, 0.6);
    SweepConfig config;
    config.thin = speed_deg_s > 10 ? 3 : 5;
    config.seed = 6;
    const RawSweep raw = simulate_lines(world, robot, X, config);
    AssemblyInput input = input_of(raw, robot, X);
    const Thickness right = thickness_of(assemble(input, robot).sweep, X, room, robot);
    ASSERT_GT(right.points, 8'000);
    EXPECT_NEAR(right.measured_m / right.by_noise_m, 1.0, 0.1);
    // As if the mirror stood while a line is measured: every beam where its line began.
    for (ScanLine& line : input.lines) line.beam_period_us = 0.0;
    const Thickness wrong = thickness_of(assemble(input, robot).sweep, X, room, robot);
    EXPECT_GT(wrong.measured_m / wrong.by_noise_m, speed_deg_s > 10 ? 2.0 : 1.1);
    std::printf("pan %.0f deg/s: walls %.2f mm, by noise %.2f mm, without the mirror's turn %.2f mm\n", speed_deg_s,
                1e3 * right.measured_m, 1e3 * right.by_noise_m, 1e3 * wrong.measured_m);
  }
}

/// As if the machine were busy: each state comes after the one before it, and late by an exponential time.
void delay(std::vector<PanTiltAngles>& angles, double mean_us) {
  Random random(9);
  for (std::size_t i = 0; i < angles.size(); ++i) {
    angles[i].utime += std::llround(-mean_us * std::log(1.0 - random.uniform()));
    if (i > 0) angles[i].utime = std::max(angles[i].utime, angles[i - 1].utime + 50);
  }
}

TEST(Assembly, WallsAreNoThickerForStatesThatComeLate) {
  const Room room = big_room();
  Robot robot = simulator::simulated_robot();
  robot.pan.speed_rad_s = radians(12);
  const Pose X = simulator::test::tilted_pose(-2, 1, 0.02, 0.6);
  SweepConfig config;
  config.thin = 3;
  const RawSweep raw = simulate_lines(room.world(), robot, X, config);
  AssemblyInput input = input_of(raw, robot, X);
  delay(input.angles, 5'000.0);  // 0.06 degrees of this pan, 1.5 cm of a wall 15 m away.
  const Thickness walls = thickness_of(assemble(input, robot).sweep, X, room, robot);
  EXPECT_NEAR(walls.measured_m / walls.by_noise_m, 1.0, 0.1);
}

/// A small sweep to break things in.
struct Small {
  Robot robot = simulator::test::quick_robot();
  Pose X = simulator::test::tilted_pose(0, 1, 0, 0.3);
  RawSweep raw = simulate_lines(Room{}.world(), robot, X, SweepConfig{});
  AssemblyInput input = input_of(raw, robot, X);
};

TEST(Assembly, IsWhatThePerfectAssemblerMakes) {
  Small small;
  const AssembledSweep assembled = assemble(small.input, small.robot);
  const Sweep expected = points_of(small.raw, small.robot).sweep;
  const Sweep& sweep = assembled.sweep;
  // The last line ends after the pan does, and what the pan does then is no part of the sweep.
  ASSERT_LE(sweep.cloud.size(), expected.cloud.size());
  ASSERT_GE(sweep.cloud.size() + 191, expected.cloud.size());
  for (std::size_t i = 0; i < sweep.cloud.size(); ++i) {
    ASSERT_LT((sweep.cloud.points[i] - expected.cloud.points[i]).norm(), 2e-5F) << i;
    ASSERT_EQ(sweep.cloud.intensity[i], expected.cloud.intensity[i]);
    ASSERT_NEAR(static_cast<double>(sweep.utime + sweep.time_offset_us[i]),
                static_cast<double>(expected.utime + expected.time_offset_us[i]), 1.0);
  }
  EXPECT_LT((sweep.origin - expected.origin).norm(), 1e-9);
  EXPECT_EQ(sweep.name, "sweep_4");
  const AssemblyReport& report = assembled.report;
  EXPECT_EQ(report.lines, 300);
  EXPECT_EQ(report.missing_lines, 0);
  EXPECT_EQ(report.without_angle, 0);
  EXPECT_GT(report.on_robot, 1000);
  EXPECT_LE(report.points + report.no_return + report.out_of_range + report.on_robot, 300 * 191);
  EXPECT_GE(report.points + report.no_return + report.out_of_range + report.on_robot, 299 * 191);
}

/// The directions of a sweep's beams without return.
std::vector<Eigen::Vector3d> no_return_of(const Sweep& sweep) {
  std::vector<Eigen::Vector3d> directions;
  for (const BeamFan& fan : sweep.no_return) {
    for (int i = 0; i < fan.beams; ++i) directions.push_back(fan.direction(i));
  }
  return directions;
}

TEST(Assembly, SaysWhereBeamsWentThatMetNothing) {
  const simulator::World field = simulator::make_world("field", 2);
  const Robot robot = simulator::test::quick_robot();
  const auto place = places_on_route(field, 1).at(0);
  const Pose X = stand_at(field, robot, place).X_world_base;
  const RawSweep raw = simulate_lines(field, robot, X, SweepConfig{});
  const AssembledSweep assembled = assemble(input_of(raw, robot, X), robot);
  const auto found = no_return_of(assembled.sweep);
  ASSERT_GT(found.size(), 20'000U);  // The sky.
  std::size_t next = 0, left_out = 0;
  for (int row = 0; row < raw.lines; ++row) {
    for (int column = 0; column < raw.beams; ++column) {
      if (raw.reading(row, column).range_count != 0) continue;
      const double time_us = raw.pattern.beam_time_us(row, column), angle = raw.pattern.angle(column);
      const Eigen::Vector3d expected = raw.pattern.X_base_laser(raw.pattern.pan_angle(time_us)).linear() *
                                       Eigen::Vector3d(std::cos(angle), std::sin(angle), 0.0);
      if (next < found.size() && (found[next] - expected).norm() < 3e-4) {
        ++next;
      } else {
        ++left_out;
      }
    }
  }
  EXPECT_EQ(next, found.size()) << "every direction is that of a beam without return, in its order";
  EXPECT_LT(left_out, found.size() / 200) << "after the pan's end, and towards the robot itself";
  EXPECT_EQ(no_return_of(points_of(raw, robot).sweep).size(), found.size() + left_out);
}

TEST(Assembly, ADazzledBeamAndOneThatNeverCameSayNothingOfWhatIsThere) {
  Small small;
  const std::size_t before = no_return_of(assemble(small.input, small.robot).sweep).size();
  auto& counts = small.input.lines[20].range_counts;
  counts[100] = counts[101] = kNoReturn;
  counts[102] = 1;  // Dazzled.
  counts[103] = kNeverCame;
  counts[104] = kNoReturn;
  const Sweep sweep = assemble(small.input, small.robot).sweep;
  EXPECT_EQ(no_return_of(sweep).size(), before + 3);
}

TEST(Assembly, TiltTurnsTheLaserForwardAndDown) {
  Small small;
  SweepConfig config;
  config.tilt = radians(20);
  const Pose X = small.X;
  const RawSweep raw = simulate_lines(Room{}.world(), small.robot, X, config);
  const Room room;
  const Thickness walls =
      thickness_of(assemble(input_of(raw, small.robot, X), small.robot).sweep, X, room, small.robot);
  EXPECT_NEAR(walls.measured_m / walls.by_noise_m, 1.0, 0.1);
}

TEST(Assembly, EveryNumberOfThreadsGivesTheSameBytes) {
  const Small small;
  std::vector<Sweep> sweeps;
  for (const int threads : {1, 2, 3}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
    sweeps.push_back(assemble(small.input, small.robot).sweep);
  }
  EXPECT_EQ(sweeps[0].cloud.points, sweeps[1].cloud.points);
  EXPECT_EQ(sweeps[0].cloud.points, sweeps[2].cloud.points);
  EXPECT_EQ(sweeps[0].time_offset_us, sweeps[2].time_offset_us);
}

TEST(Assembly, CountsWhatIsMissing) {
  Small small;
  AssemblyInput input = small.input;
  input.lines.erase(input.lines.begin() + 50, input.lines.begin() + 57);
  input.lines[20].missing_beams = 30;
  std::fill_n(input.lines[20].range_counts.begin(), 30, kNeverCame);
  const AssemblyReport all = assemble(small.input, small.robot).report, some = assemble(input, small.robot).report;
  EXPECT_EQ(some.lines, 293);
  EXPECT_EQ(some.missing_lines, 7);
  EXPECT_EQ(some.missing_beams, 30);
  EXPECT_LT(some.points, all.points);
  EXPECT_EQ(some.points + some.no_return + some.out_of_range + some.on_robot + 7 * 191 + 30,
            all.points + all.no_return + all.out_of_range + all.on_robot);
  const AssemblyReport nothing = assemble(AssemblyInput{}, small.robot).report;
  EXPECT_EQ(nothing.points, 0);
  EXPECT_EQ(nothing.missing_lines, 0);
}

TEST(Assembly, BeamsInAGapOfThePanAreNotGuessed) {
  Small small;
  AssemblyInput input = small.input;
  std::erase_if(input.angles, [&](const PanTiltAngles& a) {
    return a.utime > input.started + 3'000'000 && a.utime < input.started + 4'000'000;
  });
  const AssemblyReport gap = assemble(input, small.robot).report;
  const AssemblyReport whole = assemble(small.input, small.robot).report;
  EXPECT_NEAR(static_cast<double>(gap.without_angle), static_cast<double>(whole.points + whole.on_robot) / 12, 150);
  EXPECT_EQ(gap.points + gap.on_robot + gap.without_angle, whole.points + whole.on_robot);
  // A few lost messages are bridged: the pan turns evenly.
  input = small.input;
  std::erase_if(input.angles, [&](const PanTiltAngles& a) {
    return a.utime > input.started + 3'000'000 && a.utime < input.started + 3'200'000;
  });
  EXPECT_EQ(assemble(input, small.robot).report.without_angle, 0);
  input.angles.clear();
  EXPECT_EQ(assemble(input, small.robot).report.points, 0);
}

TEST(Assembly, SaysThatTheRobotMoved) {
  Small small;
  const Steadiness still = assemble(small.input, small.robot).report.steadiness;
  EXPECT_FALSE(still.moved);
  EXPECT_LT(still.largest_turn_rad, radians(0.05L));
  EXPECT_EQ(still.orientations, 1201U);
  ASSERT_TRUE(still.R_world_base.has_value());
  EXPECT_LT(still.R_world_base->angularDistance(simulator::Tracker(small.robot.tracker, small.X, 1).mean()),
            radians(0.01L));

  AssemblyInput input = small.input;
  for (Orientation& orientation : input.orientations) {
    if (orientation.utime < input.started + 7'000'000) continue;
    orientation.R_world_base = orientation.R_world_base * Eigen::Quaterniond(exp_so3({0.0, 0.006, 0.0}));
  }
  const Steadiness pushed = assemble(input, small.robot).report.steadiness;
  EXPECT_TRUE(pushed.moved);
  EXPECT_NEAR(pushed.largest_turn_rad, 0.006, 0.0005);
  EXPECT_NEAR(to_seconds(pushed.moved_at - input.started), 7.0, 1.01);
  input.orientations.clear();
  EXPECT_FALSE(assemble(input, small.robot).sweep.R_world_sweep.has_value());
}

}  // namespace
}  // namespace scanway
