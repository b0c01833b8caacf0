#include "modules/tools/compare/cells/seen_ground.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "common/parallel/blocks.h"
#include "modules/simulator/core/laser/robot_body.h"
#include "modules/simulator/core/ray/ray_caster.h"

namespace scanway::tools {
namespace {

using namespace scanway::simulator;
using Eigen::Vector3d;

constexpr double kOnGround_m = 0.03;     // Three deviations of a range, met at right angles.
constexpr double kOverGround_m = 0.005;  // Where a line of sight ends over the ground,
constexpr double kGrazing_m = 0.15;      // and how much of it may graze uneven ground before that.
constexpr std::size_t kRowsAtOnce = 16;

/// The ground's height at each cell's centre; NaN: none.
std::vector<double> ground_heights(const World& world, const CellWindow& window) {
  std::vector<double> heights(window.size(), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t i = 0; i < world.ground.size(); ++i) {
    for_centres(FlatTriangle(world.ground.corners(i)), window, [&](std::int32_t x, std::int32_t y, double z) {
      double& height = heights[window.index(x, y)];
      if (!(z <= height)) height = z;
    });
  }
  return heights;
}

/// The cells in which a point of the sweep lies on the ground.
std::vector<std::uint8_t> ground_points(const TrueSweep& taken, const CellWindow& window,
                                        const std::vector<double>& heights) {
  std::vector<std::uint8_t> hit(window.size(), 0);
  for (const Eigen::Vector3f& point : taken.sweep->cloud.points) {
    const Vector3d p = taken.X_world_base * point.cast<double>();
    const std::int32_t x = window.cell(p.x()), y = window.cell(p.y());
    if (x < window.low_x || y < window.low_y || x >= window.high_x || y >= window.high_y) continue;
    const std::size_t i = window.index(x, y);
    if (std::fabs(p.z() - heights[i]) <= kOnGround_m) hit[i] = 1;
  }
  return hit;
}

/// How many cells up or down the nearest hit of the same column is, at most `reach + 1`.
std::vector<std::uint8_t> column_distances(const std::vector<std::uint8_t>& hit, const CellWindow& window, int reach) {
  std::vector<std::uint8_t> distances(hit.size());
  const auto none = static_cast<std::uint8_t>(reach + 1);
  const auto pass = [&](std::int32_t x, std::int32_t y, int last) {
    const std::size_t i = window.index(x, y);
    const std::uint8_t so_far =
        y == (last > 0 ? window.low_y : window.high_y - 1) ? none : distances[window.index(x, y - last)];
    const auto next = static_cast<std::uint8_t>(std::min<int>(none, so_far + 1));
    distances[i] = hit[i] != 0 ? 0 : last > 0 ? next : std::min(distances[i], next);
  };
  for (std::int32_t y = window.low_y; y < window.high_y; ++y) {
    for (std::int32_t x = window.low_x; x < window.high_x; ++x) pass(x, y, 1);
  }
  for (std::int32_t y = window.high_y; y-- > window.low_y;) {
    for (std::int32_t x = window.low_x; x < window.high_x; ++x) pass(x, y, -1);
  }
  return distances;
}

/// The cells whose centre is within kGroundReach_m of a hit's.
std::vector<std::uint8_t> near_hits(const std::vector<std::uint8_t>& hit, const CellWindow& window) {
  const int reach = static_cast<int>(std::floor(kGroundReach_m / window.resolution_m));
  const std::vector<std::uint8_t> distances = column_distances(hit, window, reach);
  std::vector<std::uint8_t> near(hit.size(), 0);
  const auto is_near = [&](std::int32_t x, std::int32_t y) {
    const std::int32_t from = std::max(window.low_x, x - reach), to = std::min(window.high_x - 1, x + reach);
    for (std::int32_t other = from; other <= to; ++other) {
      const int dx = other - x, dy = distances[window.index(other, y)];
      if (dy <= reach && dx * dx + dy * dy <= reach * reach) return true;
    }
    return false;
  };
  for_blocks(static_cast<std::size_t>(window.high_y - window.low_y), kRowsAtOnce,
             [&](std::size_t begin, std::size_t end, std::size_t) {
               for (auto y = window.low_y + static_cast<std::int32_t>(begin);
                    y < window.low_y + static_cast<std::int32_t>(end); ++y) {
                 for (std::int32_t x = window.low_x; x < window.high_x; ++x) near[window.index(x, y)] = is_near(x, y);
               }
             });
  return near;
}

/// Whether nothing stands between the sensor and a place on the ground.
class LineOfSight {
 public:
  LineOfSight(const World& world, const Robot& robot, const TrueSweep& taken)
      : body_(body_mesh(robot, taken.X_world_base)),
        caster_(std::array<const Mesh*, 3>{&world.ground, &world.objects, &body_}),
        sensor_(taken.X_world_base * taken.sweep->origin) {}

  bool reaches(double x, double y, double ground) const {
    const Vector3d way = Vector3d(x, y, ground + kOverGround_m) - sensor_;
    const double length = way.norm();
    const auto hit = caster_.cast(sensor_, way / length, length);
    return !hit || (hit->surface.label == Label::ground && hit->range_m >= length - kGrazing_m);
  }

  /// Every kAirGap_m up to the body's height.
  bool reaches_air(double x, double y, double ground, const Robot::Body& body) const {
    for (double above = body.climbable_step_m; above < body.height_m; above += kAirGap_m) {
      const Vector3d way = Vector3d(x, y, ground + above) - sensor_;
      const double length = way.norm();
      if (caster_.cast(sensor_, way / length, length)) return false;
    }
    return true;
  }

 private:
  Mesh body_;
  RayCaster caster_;
  Vector3d sensor_;
};

}  // namespace

SeenGround seen_ground(const World& world, const Robot& robot, const std::vector<TrueSweep>& sweeps,
                       const CellWindow& window) {
  SeenGround seen{window, std::vector<std::uint8_t>(window.size(), 0), std::vector<std::uint8_t>(window.size(), 0)};
  const std::vector<double> heights = ground_heights(world, window);
  for (const TrueSweep& taken : sweeps) {
    const std::vector<std::uint8_t> near = near_hits(ground_points(taken, window, heights), window);
    const LineOfSight sight(world, robot, taken);
    const auto width = static_cast<std::size_t>(window.width());
    for_blocks(window.size(), kRowsAtOnce * width, [&](std::size_t begin, std::size_t end, std::size_t) {
      for (std::size_t i = begin; i < end; ++i) {
        if (near[i] == 0 || std::isnan(heights[i])) continue;
        ++seen.near[i];
        const double x = window.centre(window.low_x + static_cast<std::int32_t>(i % width));
        const double y = window.centre(window.low_y + static_cast<std::int32_t>(i / width));
        if (sight.reaches(x, y, heights[i])) ++seen.visible[i];
      }
    });
  }
  return seen;
}

std::vector<std::uint8_t> seen_with_air(const World& world, const Robot& robot, const std::vector<TrueSweep>& sweeps,
                                        const CellWindow& window, const std::vector<std::size_t>& cells) {
  std::vector<std::uint8_t> seen(cells.size(), 0);
  const std::vector<double> heights = ground_heights(world, window);
  const auto width = static_cast<std::size_t>(window.width());
  for (const TrueSweep& taken : sweeps) {
    const LineOfSight sight(world, robot, taken);
    for_blocks(cells.size(), kRowsAtOnce * width, [&](std::size_t begin, std::size_t end, std::size_t) {
      for (std::size_t i = begin; i < end; ++i) {
        const double x = window.centre(window.low_x + static_cast<std::int32_t>(cells[i] % width));
        const double y = window.centre(window.low_y + static_cast<std::int32_t>(cells[i] / width));
        const double ground = heights[cells[i]];
        if (sight.reaches(x, y, ground) && sight.reaches_air(x, y, ground, robot.body)) ++seen[i];
      }
    });
  }
  return seen;
}

}  // namespace scanway::tools
