#include "modules/simulator/core/laser/raw_sweep.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "common/math/repeatable.h"
#include "common/parallel/blocks.h"
#include "modules/simulator/core/laser/beam_random.h"
#include "modules/simulator/core/laser/robot_body.h"

namespace scanway::simulator {
namespace {

constexpr std::size_t kLinesAtOnce = 8;
constexpr double kBodyMargin_m = 0.08;  // Mixed pixels at the body's edge lie outside it; the ground there is hidden.

int kept(int all, int thin) { return (all + thin - 1) / thin; }

bool above_footprint(const std::vector<Eigen::Vector2d>& footprint, const Eigen::Vector3d& p) {
  for (std::size_t i = 0; i < footprint.size(); ++i) {
    const Eigen::Vector2d& a = footprint[i];
    const Eigen::Vector2d edge = footprint[(i + 1) % footprint.size()] - a;
    const double outside = edge.y() * (p.x() - a.x()) - edge.x() * (p.y() - a.y());
    if (outside > kBodyMargin_m * edge.norm()) return false;
  }
  return true;
}

/// The points of one line.
struct LinePoints {
  std::vector<Eigen::Vector3f> points;
  std::vector<float> rssi;
  std::vector<double> time_us;
  std::vector<Label> labels;
  std::vector<BeamFan> no_return;
};

std::vector<BeamFan> fans_of_line(const RawSweep& raw, int row) {
  std::vector<BeamFan> fans;
  const auto direction = [&](int column) {
    const int beam = raw.beam_of(column);
    const double angle = raw.pattern.angle(beam),
                 pan = raw.pattern.pan_angle(raw.pattern.beam_time_us(raw.line_of(row), beam));
    const Eigen::Vector3d in_laser(repeatable::cos(angle), repeatable::sin(angle), 0.0);
    return to_direction(raw.pattern.X_base_laser(pan).linear() * in_laser);
  };
  const auto none = [&](int column) { return raw.reading(row, column).range_count == 0; };
  find_fans(raw.beams, raw.pattern.angle_step() * raw.thin, none, [&](int first, int last) {
    fans.push_back({direction(first), direction(last), static_cast<std::int16_t>(last - first + 1)});
  });
  return fans;
}

LinePoints line_points(const RawSweep& raw, const Robot& robot, int row, bool keep_body) {
  LinePoints line;
  for (int column = 0; column < raw.beams; ++column) {
    const BeamReading& reading = raw.reading(row, column);
    if (reading.range_count == 0) continue;
    const int beam = raw.beam_of(column);
    const double time_us = raw.pattern.beam_time_us(raw.line_of(row), beam), angle = raw.pattern.angle(beam);
    const double range = reading.range_count * raw.range_scale_m;
    const Eigen::Vector3d in_laser(range * repeatable::cos(angle), range * repeatable::sin(angle), 0.0);
    const Eigen::Vector3d p = raw.pattern.X_base_laser(raw.pattern.pan_angle(time_us)) * in_laser;
    if (!keep_body && p.z() < robot.body.height_m && above_footprint(robot.body.footprint, p)) continue;
    line.points.push_back(p.cast<float>());
    line.rssi.push_back(reading.rssi_count);
    line.time_us.push_back(time_us);
    line.labels.push_back(reading.label);
  }
  line.no_return = fans_of_line(raw, row);
  return line;
}

}  // namespace

RayCaster caster_of(const World& world) { return RayCaster(std::array{&world.ground, &world.objects}); }

RawSweep simulate_lines(const RayCaster& world, const Robot& robot, const Pose& X_world_base,
                        const SweepConfig& config) {
  const Mesh body_triangles = body_mesh(robot, X_world_base);
  const RayCaster body(std::array{&body_triangles});
  const People people(world, X_world_base.translation(), config.people, config.seed);
  const BeamModel model(robot.laser, world, body, people);
  RawSweep raw{
      ScanPattern(robot, config.start, config.seed, config.tilt), config.thin, 0, 0, model.range_scale_m(), {}};
  raw.lines = kept(raw.pattern.lines(), config.thin);
  raw.beams = kept(raw.pattern.beams(), config.thin);
  raw.readings.resize(static_cast<std::size_t>(raw.lines) * static_cast<std::size_t>(raw.beams));
  for_blocks(static_cast<std::size_t>(raw.lines), kLinesAtOnce, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t row = begin; row < end; ++row) {
      const int line = raw.line_of(static_cast<int>(row));
      BeamReading* out = &raw.readings[row * static_cast<std::size_t>(raw.beams)];
      for (int column = 0; column < raw.beams; ++column) {
        const int beam = raw.beam_of(column);
        const double time_us = raw.pattern.beam_time_us(line, beam);
        const Pose X_world_laser = X_world_base * raw.pattern.X_base_laser(raw.pattern.pan_angle(time_us));
        out[column] = model.read(X_world_laser, raw.pattern.angle(beam), time_us, beam_random(config.seed, line, beam));
      }
    }
  });
  return raw;
}

RawSweep simulate_lines(const World& world, const Robot& robot, const Pose& X_world_base, const SweepConfig& config) {
  return simulate_lines(caster_of(world), robot, X_world_base, config);
}

LabelledSweep points_of(const RawSweep& raw, const Robot& robot, bool keep_body) {
  std::vector<LinePoints> lines(static_cast<std::size_t>(raw.lines));
  for_blocks(lines.size(), kLinesAtOnce, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t row = begin; row < end; ++row)
      lines[row] = line_points(raw, robot, static_cast<int>(row), keep_body);
  });
  LabelledSweep result;
  Sweep& sweep = result.sweep;
  std::vector<double> time_us;
  for (const LinePoints& line : lines) {
    sweep.cloud.points.insert(sweep.cloud.points.end(), line.points.begin(), line.points.end());
    sweep.cloud.intensity.insert(sweep.cloud.intensity.end(), line.rssi.begin(), line.rssi.end());
    time_us.insert(time_us.end(), line.time_us.begin(), line.time_us.end());
    result.labels.insert(result.labels.end(), line.labels.begin(), line.labels.end());
    sweep.no_return.insert(sweep.no_return.end(), line.no_return.begin(), line.no_return.end());
  }
  const double last_us = time_us.empty() ? 0.0 : std::floor(time_us.back() + 0.5);
  sweep.utime = raw.pattern.start() + static_cast<Utime>(last_us);
  for (const double time : time_us) {
    sweep.time_offset_us.push_back(static_cast<std::int32_t>(std::min(0.0, std::floor(time - last_us + 0.5))));
  }
  // The mirror goes round the pan axis; its mean place is on it.
  const Eigen::Vector3d back = raw.pattern.X_base_laser(0.0).translation(),
                        ahead = raw.pattern.X_base_laser(repeatable::kPi).translation();
  sweep.origin = (back + ahead) / 2;
  sweep.sensor_height_m = sweep.origin.z();
  return result;
}

}  // namespace scanway::simulator
