#include "modules/mapper/core/assembly/assembly.h"

#include <algorithm>
#include <cmath>
#include <optional>
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
  std::vector<BeamFan> no_return;
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
      const double after_us = time_of(line, beam);
      if (!in_sweep_time(after_us)) continue;
      in_sweep = true;
      add_beam(line, beam, after_us, part);
    }
    if (!in_sweep) return;
    ++part.report.lines;
    part.report.missing_beams += line.missing_beams;
    add_no_return(line, part);
  }

  /// The mirror goes round the pan axis: the middle of its way.
  Vector3d origin() const {
    const double half_turn = repeatable::kPi;
    return (X_base_laser({0, 0.0, 0.0}).translation() + X_base_laser({0, half_turn, 0.0}).translation()) / 2;
  }

 private:
  /// Microseconds since the sweep's start.
  double time_of(const ScanLine& line, std::size_t beam) const {
    return static_cast<double>(line.utime - input_.started) + static_cast<double>(beam) * line.beam_period_us;
  }
  bool in_sweep_time(double after_us) const {
    return after_us >= 0.0 && after_us <= static_cast<double>(input_.ended - input_.started);
  }
  std::optional<Pose> X_base_laser_at(double after_us) const {
    const auto angles = track_.at(after_us + static_cast<double>(input_.started - track_.start()));
    return angles ? std::optional(X_base_laser(*angles)) : std::nullopt;
  }

  Pose X_base_laser(const PanTiltAngles& angles) const {
    Pose X_pan0_tilt = Pose::Identity();
    X_pan0_tilt.linear() = rotation_about_z(angles.pan) * exp_so3({0.0, angles.tilt, 0.0});
    return X_base_pan0_ * X_pan0_tilt * X_tilt_laser_;
  }

  void add_beam(const ScanLine& line, std::size_t beam, double after_us, Part& part) const {
    const std::uint16_t count = line.range_counts[beam];
    if (count == kNeverCame) return;
    if (count < kFirstRangeCount) {
      ++part.report.no_return;
      return;
    }
    const double range = range_of(line, beam);
    if (range < robot_.laser.min_range_m || range > robot_.laser.max_range_m) {
      ++part.report.out_of_range;
      return;
    }
    const auto X_base_laser = X_base_laser_at(after_us);
    if (!X_base_laser) {
      ++part.report.without_angle;
      return;
    }
    const Vector3d p = *X_base_laser * Vector3d(range * direction_in_laser(line, beam));
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

  static double range_of(const ScanLine& line, std::size_t beam) {
    return line.range_counts[beam] * line.range_scale_m + line.range_offset_m;
  }
  static Vector3d direction_in_laser(const ScanLine& line, std::size_t beam) {
    const double angle = line.start_angle_rad + static_cast<double>(beam) * line.angle_step_rad;
    return {repeatable::sin(angle), -repeatable::cos(angle), 0.0};
  }

  /// A beam that met nothing, or only what lies beyond the laser's range. Dazzled beams and those that never came say
  /// nothing of what is there.
  void add_no_return(const ScanLine& line, Part& part) const {
    const auto met_nothing = [&](int i) {
      const auto beam = static_cast<std::size_t>(i);
      const std::uint16_t count = line.range_counts[beam];
      const bool beyond = count >= kFirstRangeCount && range_of(line, beam) > robot_.laser.max_range_m;
      return (count == kNoReturn || beyond) && in_sweep_time(time_of(line, beam));
    };
    find_fans(static_cast<int>(line.range_counts.size()), line.angle_step_rad, met_nothing, [&](int first, int last) {
      const auto from = clear_direction(line, first), to = clear_direction(line, last);
      if (from && to) part.no_return.push_back({*from, *to, static_cast<std::int16_t>(last - first + 1)});
    });
  }

  /// Nothing where the pan's angle is not known, and where the robot's own body is in the beam's way.
  std::optional<BeamFan::Direction> clear_direction(const ScanLine& line, int i) const {
    const auto beam = static_cast<std::size_t>(i);
    const auto X_base_laser = X_base_laser_at(time_of(line, beam));
    if (!X_base_laser) return std::nullopt;
    const Vector3d laser = X_base_laser->translation();
    const Vector3d direction = X_base_laser->linear() * direction_in_laser(line, beam);
    const double above = laser.z() - robot_.body.height_m;
    if (direction.z() < 0.0 && on_robot(laser + direction * (above / -direction.z()))) return std::nullopt;
    return to_direction(direction);
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
    sweep.no_return.insert(sweep.no_return.end(), part.no_return.begin(), part.no_return.end());
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
