#include "modules/mapper/core/assembly/assembly.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "common/geometry/pose.h"
#include "common/math/repeatable.h"
#include "common/parallel/blocks.h"
#include "modules/mapper/core/assembly/angle_track.h"

namespace scanway {
namespace {

using Eigen::Vector3d;

constexpr std::size_t kLinesAtOnce = 16;
// The pan-tilt tells its angles every 20 ms; over a few lost messages its motion is still straight.
constexpr Utime kLongestAngleGap_us = 500'000;
// At the body's edge pixels mix with the ground behind it, which the body hides up to about here.
constexpr double kBodyMargin_m = 0.08;

/// What the beams of some lines became.
struct Part {
  std::vector<Eigen::Vector3f> points;
  std::vector<float> intensity;
  std::vector<double> after_us;  ///< Since the sweep's start.
  AssemblyReport report;
};

class LineAssembler {
 public:
  LineAssembler(const AssemblyInput& input, const Robot& robot)
      : input_(input),
        robot_(robot),
        track_(input.angles, kLongestAngleGap_us),
        X_base_pan0_(robot.mounts.base_mount.pose() * robot.mounts.mount_pan.pose()),
        X_tilt_laser_(robot.mounts.pan_laser.pose()) {}

  void add(const ScanLine& line, Part& part) const {
    bool in_sweep = false;
    for (std::size_t beam = 0; beam < line.range_counts.size(); ++beam) {
      const double into_line_us = static_cast<double>(beam) * line.beam_period_us;
      const double after_us = static_cast<double>(line.utime - input_.started) + into_line_us;
      if (after_us < 0.0 || after_us > static_cast<double>(input_.ended - input_.started)) continue;
      in_sweep = true;
      add_beam(line, beam, after_us, part);
    }
    if (!in_sweep) return;
    ++part.report.lines;
    part.report.missing_beams += line.missing_beams;
    part.report.no_return -= line.missing_beams;  // They count as 0, and are none.
  }

  /// The mirror goes round the pan axis: the middle of its way.
  Vector3d origin() const {
    const double half_turn = repeatable::kPi;
    return (X_base_laser({0, 0.0, 0.0}).translation() + X_base_laser({0, half_turn, 0.0}).translation()) / 2;
  }

 private:
  Pose X_base_laser(const PanTiltAngles& angles) const {
    Pose X_pan0_tilt = Pose::Identity();
    X_pan0_tilt.linear() = rotation_about_z(angles.pan) * exp_so3({0.0, angles.tilt, 0.0});
    return X_base_pan0_ * X_pan0_tilt * X_tilt_laser_;
  }

  void add_beam(const ScanLine& line, std::size_t beam, double after_us, Part& part) const {
    const std::uint16_t count = line.range_counts[beam];
    if (count < kFirstRangeCount) {
      ++part.report.no_return;
      return;
    }
    const double range = count * line.range_scale_m + line.range_offset_m;
    if (range < robot_.laser.min_range_m || range > robot_.laser.max_range_m) {
      ++part.report.out_of_range;
      return;
    }
    const auto angles = track_.at(after_us + static_cast<double>(input_.started - track_.start()));
    if (!angles) {
      ++part.report.without_angle;
      return;
    }
    const double angle = line.start_angle_rad + static_cast<double>(beam) * line.angle_step_rad;
    const Vector3d in_laser(range * repeatable::sin(angle), -range * repeatable::cos(angle), 0.0);
    const Vector3d p = X_base_laser(*angles) * in_laser;
    if (on_robot(p)) {
      ++part.report.on_robot;
      return;
    }
    part.points.push_back(p.cast<float>());
    part.after_us.push_back(after_us);
    if (!line.rssi_counts.empty()) {
      part.intensity.push_back(static_cast<float>(line.rssi_counts[beam] * line.rssi_scale + line.rssi_offset));
    }
  }

  /// Above the footprint and below the robot's height there is nothing but the robot.
  bool on_robot(const Vector3d& p) const {
    if (p.z() > robot_.body.height_m) return false;
    const auto& footprint = robot_.body.footprint;
    for (std::size_t i = 0; i < footprint.size(); ++i) {
      const Eigen::Vector2d &a = footprint[i], edge = footprint[(i + 1) % footprint.size()] - a;
      const double outside = edge.y() * (p.x() - a.x()) - edge.x() * (p.y() - a.y());
      if (outside > kBodyMargin_m * edge.norm()) return false;
    }
    return true;
  }

  const AssemblyInput& input_;
  const Robot& robot_;
  AngleTrack track_;
  Pose X_base_pan0_, X_tilt_laser_;
};

void add_counts(AssemblyReport& sum, const AssemblyReport& part) {
  sum.lines += part.lines;
  sum.missing_beams += part.missing_beams;
  sum.no_return += part.no_return;
  sum.out_of_range += part.out_of_range;
  sum.on_robot += part.on_robot;
  sum.without_angle += part.without_angle;
}

/// Numbers that lack between the first and the last line that begins during the sweep.
std::int64_t missing_lines(const AssemblyInput& input) {
  std::int64_t first = 0, last = -1, there = 0;
  for (const ScanLine& line : input.lines) {
    if (line.utime < input.started || line.utime > input.ended) continue;
    if (there++ == 0) first = line.number;
    last = line.number;
  }
  return last - first + 1 - there;
}

void set_times(Sweep& sweep, Utime started, const std::vector<double>& after_us) {
  const auto last = after_us.empty() ? Utime{0} : static_cast<Utime>(std::floor(after_us.back() + 0.5));
  sweep.utime = started + last;
  sweep.time_offset_us.reserve(after_us.size());
  for (const double after : after_us) {
    const double offset = std::floor(after - static_cast<double>(last) + 0.5);
    sweep.time_offset_us.push_back(static_cast<std::int32_t>(std::min(0.0, offset)));
  }
}

}  // namespace

AssembledSweep assemble(const AssemblyInput& input, const Robot& robot) {
  const LineAssembler assembler(input, robot);
  std::vector<Part> parts((input.lines.size() + kLinesAtOnce - 1) / kLinesAtOnce);
  for_blocks(input.lines.size(), kLinesAtOnce, [&](std::size_t begin, std::size_t end, std::size_t block) {
    for (std::size_t i = begin; i < end; ++i) assembler.add(input.lines[i], parts[block]);
  });

  AssembledSweep result;
  Sweep& sweep = result.sweep;
  std::vector<double> after_us;
  for (const Part& part : parts) {
    sweep.cloud.points.insert(sweep.cloud.points.end(), part.points.begin(), part.points.end());
    sweep.cloud.intensity.insert(sweep.cloud.intensity.end(), part.intensity.begin(), part.intensity.end());
    after_us.insert(after_us.end(), part.after_us.begin(), part.after_us.end());
    add_counts(result.report, part.report);
  }
  if (sweep.cloud.intensity.size() != sweep.cloud.size()) sweep.cloud.intensity.clear();  // Not all lines had it.
  set_times(sweep, input.started, after_us);
  result.report.points = static_cast<std::int64_t>(sweep.cloud.size());
  result.report.missing_lines = missing_lines(input);
  result.report.steadiness = steadiness_of(input.orientations, input.started, input.ended);
  sweep.name = "sweep_" + std::to_string(input.sweep);
  sweep.origin = assembler.origin();
  sweep.sensor_height_m = sweep.origin.z();
  sweep.R_world_sweep = result.report.steadiness.R_world_base;
  return result;
}

}  // namespace scanway
