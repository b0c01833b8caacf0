#include "tests/bench/ground/aerial/stands_filter.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "modules/mapper/core/ground/ground_surface.h"

namespace scanway::bench {
namespace {

constexpr int kBetween = 10;     // columns from stand to stand
constexpr int kLeastReach = 20;  // columns
constexpr double kAbove = 1.0;   // metres, shrunk: of the pretended sensor above all points

/// The sample, shrunk, and its points by squares of kBetween columns.
struct Shrunk {
  double factor = 1.0;
  std::vector<Eigen::Vector3f> points;
  Eigen::Vector2d low;
  int width = 0, height = 0;
  std::vector<std::vector<std::size_t>> squares;

  static constexpr double kSide = kBetween * GroundSurface::kColumn;
};

Shrunk shrink(const Sample& sample) {
  Shrunk shrunk;
  shrunk.factor = GroundSurface::kColumn / sample.spacing_m();
  for (const Eigen::Vector3d& p : sample.points) shrunk.points.push_back((p * shrunk.factor).cast<float>());
  Eigen::Vector2f low = shrunk.points.front().head<2>(), high = low;
  for (const auto& p : shrunk.points) low = low.cwiseMin(p.head<2>()), high = high.cwiseMax(p.head<2>());
  shrunk.low = low.cast<double>();
  shrunk.width = static_cast<int>((high.x() - low.x()) / Shrunk::kSide) + 1;
  shrunk.height = static_cast<int>((high.y() - low.y()) / Shrunk::kSide) + 1;
  shrunk.squares.resize(static_cast<std::size_t>(shrunk.width) * shrunk.height);
  for (std::size_t i = 0; i < shrunk.points.size(); ++i) {
    const Eigen::Vector2d at = (shrunk.points[i].head<2>().cast<double>() - shrunk.low) / Shrunk::kSide;
    shrunk.squares[static_cast<std::size_t>(at.y()) * shrunk.width + static_cast<std::size_t>(at.x())].push_back(i);
  }
  return shrunk;
}

std::vector<std::size_t> points_around(const Shrunk& shrunk, int sx, int sy, double reach) {
  const int squares = static_cast<int>(std::ceil(reach / Shrunk::kSide));
  std::vector<std::size_t> around;
  for (int y = std::max(sy - squares, 0); y <= std::min(sy + squares, shrunk.height - 1); ++y) {
    for (int x = std::max(sx - squares, 0); x <= std::min(sx + squares, shrunk.width - 1); ++x) {
      const auto& square = shrunk.squares[static_cast<std::size_t>(y) * shrunk.width + x];
      around.insert(around.end(), square.begin(), square.end());
    }
  }
  return around;
}

/// What one stand sees.
MapPoints sweep_at(const Shrunk& shrunk, int sx, int sy, const std::vector<std::size_t>& around) {
  MapPoints sweep;
  double highest = -1e9;
  for (const std::size_t i : around) {
    sweep.points.push_back(shrunk.points[i]);
    highest = std::max<double>(highest, shrunk.points[i].z());
  }
  sweep.origin << shrunk.low.x() + (sx + 0.5) * Shrunk::kSide, shrunk.low.y() + (sy + 0.5) * Shrunk::kSide,
      highest + kAbove;
  return sweep;
}

std::optional<GroundSurface> ground_at(const MapPoints& sweep, const StandsConfig& config, double factor,
                                       double reach) {
  GroundPlaneConfig plane;
  plane.max_slope = config.slope;
  plane.inlier_m = config.step_m * factor;
  plane.max_range_m = reach;
  const std::optional<GroundPlane> found = find_ground_plane(sweep, plane);
  if (!found) return std::nullopt;
  GroundSurfaceConfig surface;
  surface.climbable_step_m = config.step_m * factor;
  surface.climbable_slope = config.slope;
  surface.range_sigma_m = config.sigma_m * factor;
  surface.max_range_m = reach;
  return GroundSurface(sweep, *found, surface);
}

}  // namespace

std::vector<bool> stands_filter(const Sample& sample, const StandsConfig& config) {
  const Shrunk shrunk = shrink(sample);
  const double reach = std::max(config.reach_m * shrunk.factor, kLeastReach * GroundSurface::kColumn);
  const double band = (config.step_m + config.sigma_m) * shrunk.factor;
  std::vector<int> votes(sample.points.size(), 0);
  for (int sy = 0; sy < shrunk.height; ++sy) {
    for (int sx = 0; sx < shrunk.width; ++sx) {
      const std::vector<std::size_t> around = points_around(shrunk, sx, sy, reach);
      const auto surface = ground_at(sweep_at(shrunk, sx, sy, around), config, shrunk.factor, reach);
      if (!surface) continue;
      for (const std::size_t i : around) {
        const Eigen::Vector3f& p = shrunk.points[i];
        const GroundSurface::Place place = surface->at(p.x(), p.y());
        if (place.support > 0) votes[i] += std::fabs(p.z() - place.height) <= band ? 1 : -1;
      }
    }
  }
  std::vector<bool> ground;
  for (const int vote : votes) ground.push_back(vote > 0);
  return ground;
}

}  // namespace scanway::bench
