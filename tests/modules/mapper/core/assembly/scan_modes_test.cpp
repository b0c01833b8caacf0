// Sweeps in every mode of the LMS500, the interlaced ones too: a room's surfaces are as thin as noise makes them.
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "common/random/random.h"
#include "modules/mapper/core/assembly/assembly.h"
#include "tests/modules/simulator/core/test_worlds.h"

namespace scanway {
namespace {

/// SICK's variant table: frequency, beams in two degrees, turns.
struct ScannerMode {
  int frequency_hz, beams_in_two_deg, turns = 1;

  double resolution_deg() const { return 2.0 / beams_in_two_deg; }
  double step_deg() const { return resolution_deg() * turns; }
};

constexpr double kPanSpeed = radians(180), kSigma_m = 0.01;
constexpr Utime kSweepBegan = 1'700'000'000'000'000, kSweepLasts = 2 * kMicrosecondsPerSecond;

/// A sweep in a room, written down from the data sheets: beam by beam, the mirror and the pan both turning.
class WrittenSweep {
 public:
  explicit WrittenSweep(const ScannerMode& mode) : mode_(mode) {
    input_.started = kSweepBegan;
    input_.ended = kSweepBegan + kSweepLasts;
    for (Utime after = -100'000; after <= kSweepLasts + 100'000; after += 20'000) {
      input_.angles.push_back({kSweepBegan + after, pan_at(static_cast<double>(after)), 0.0});
    }
    for (int turn = 0; turn < 2 * mode.frequency_hz; ++turn) input_.lines.push_back(line(turn));
  }

  const AssemblyInput& input() const { return input_; }
  /// Of what noise does to the distances from the room's surfaces.
  double by_noise_m() const { return kSigma_m * std::sqrt(facing_ / beams_); }
  /// Root mean square distance of the points from the nearest surface.
  double measured_m(const Sweep& sweep) const {
    double squares = 0.0;
    for (const Eigen::Vector3f& point : sweep.cloud.points) {
      const Eigen::Vector3d p = point.cast<double>();
      const double off = std::min((p - room_.low).cwiseAbs().minCoeff(), (p - room_.high).cwiseAbs().minCoeff());
      squares += off * off;
    }
    return std::sqrt(squares / static_cast<double>(sweep.cloud.size()));
  }
  const Robot& robot() const { return robot_; }

 private:
  static double pan_at(double after_us) { return kPanSpeed * after_us * 1e-6; }

  ScanLine line(int turn) {
    constexpr int kOfFour[] = {0, 2, 1, 3};  // As recorded.
    const int shift = mode_.turns == 4 ? kOfFour[turn % 4] : turn % mode_.turns;
    const double turn_us = 1e6 / mode_.frequency_hz, first_deg = shift * mode_.resolution_deg() - 5.0;
    ScanLine line;
    line.number = turn;
    line.utime = kSweepBegan + std::llround(turn * turn_us + shift * mode_.resolution_deg() / 360.0 * turn_us);
    line.beam_period_us = mode_.step_deg() / 360.0 * turn_us;
    line.start_angle_rad = radians(1) * first_deg;
    line.angle_step_rad = radians(1) * mode_.step_deg();
    const int beams = static_cast<int>(std::floor((185.0 - first_deg) / mode_.step_deg() + 1e-6)) + 1;
    for (int beam = 0; beam < beams; ++beam) line.range_counts.push_back(count(line, beam));
    return line;
  }

  std::uint16_t count(const ScanLine& line, int beam) {
    const double after_us = static_cast<double>(line.utime - kSweepBegan) + beam * line.beam_period_us;
    const double angle = line.start_angle_rad + beam * line.angle_step_rad;
    Pose X_pan0_pan = Pose::Identity();
    X_pan0_pan.linear() = rotation_about_z(pan_at(after_us));
    const auto& mounts = robot_.mounts;
    const Pose X = mounts.base_mount.pose() * mounts.mount_pan.pose() * X_pan0_pan * mounts.pan_laser.pose();
    const Eigen::Vector3d direction = X.linear() * Eigen::Vector3d(std::sin(angle), -std::cos(angle), 0.0);
    const auto [range, to_next] = room_.distance(X.translation(), direction);
    const Eigen::Vector3d hit = X.translation() + range * direction;
    const bool near_robot = hit.head<2>().norm() < 0.5;
    if (to_next < 0.3 || near_robot || after_us > static_cast<double>(kSweepLasts)) return kNoReturn;
    for (int axis = 0; axis < 3; ++axis) {
      const double plane = direction[axis] > 0 ? room_.high[axis] : room_.low[axis];
      if (std::fabs(hit[axis] - plane) < 1e-6) facing_ += direction[axis] * direction[axis];
    }
    ++beams_;
    return static_cast<std::uint16_t>(std::llround((range + kSigma_m * random_.normal()) * 1e3));
  }

  const simulator::test::Room room_;
  const Robot robot_ = simulator::simulated_robot();
  ScannerMode mode_;
  Random random_{4};
  AssemblyInput input_;
  double facing_ = 0.0;
  int beams_ = 0;
};

class EveryScanMode : public testing::TestWithParam<ScannerMode> {};

TEST_P(EveryScanMode, TheRoomIsAsThinAsItsNoise) {
  const ScannerMode mode = GetParam();
  WrittenSweep written(mode);
  const AssembledSweep assembled = assemble(written.input(), written.robot());
  EXPECT_EQ(assembled.report.lines, 2 * mode.frequency_hz);
  EXPECT_EQ(assembled.report.missing_lines, 0);
  ASSERT_GT(assembled.report.points, assembled.report.no_return);
  EXPECT_NEAR(written.measured_m(assembled.sweep) / written.by_noise_m(), 1.0, 0.1);
  if (mode.turns == 1 || mode.step_deg() < 0.6) return;
  AssemblyInput wrong = written.input();  // As if every turn began where the first one does.
  for (ScanLine& line : wrong.lines) line.start_angle_rad = wrong.lines.front().start_angle_rad;
  EXPECT_GT(written.measured_m(assemble(wrong, written.robot()).sweep) / written.by_noise_m(), 1.2);
}

INSTANTIATE_TEST_SUITE_P(Lms500, EveryScanMode,
                         testing::Values(ScannerMode{25, 12}, ScannerMode{25, 8}, ScannerMode{35, 8},
                                         ScannerMode{35, 4}, ScannerMode{50, 6}, ScannerMode{50, 4}, ScannerMode{75, 4},
                                         ScannerMode{75, 2}, ScannerMode{100, 3}, ScannerMode{100, 2},
                                         ScannerMode{50, 12, 2}, ScannerMode{75, 8, 2}, ScannerMode{100, 12, 4},
                                         ScannerMode{100, 6, 2}, ScannerMode{100, 4, 2}, ScannerMode{25, 24, 2},
                                         ScannerMode{25, 48, 4}),
                         [](const auto& mode) {
                           return std::to_string(mode.param.frequency_hz) + "_hz_" +
                                  std::to_string(mode.param.beams_in_two_deg) + "_beams_in_two_degrees_of_" +
                                  std::to_string(mode.param.turns) + "_turns";
                         });

}  // namespace
}  // namespace scanway
