#include "modules/mapper/core/costmap/obstacle_returns.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "modules/mapper/core/cloud/radix_sort.h"
#include "modules/mapper/core/costmap/polar.h"

namespace scanway {
namespace {

constexpr double kUnit = 1e-4;           // metres: of the ranges that returns are sorted by
constexpr int kNoiseDeviations = 4;      // how far noise throws a return
constexpr std::uint32_t kDominance = 4;  // a place with so many times the returns is the surface

struct Keyed {
  std::uint64_t key;  ///< Sector, then range in kUnit.
  ObstacleReturn value;
};

/// Whether a return at p, relative to the sensor, is from the face of a pit's far side: below the ground behind it.
bool below_ground_behind(const Eigen::Vector3d& p, double range, const Eigen::Vector3d& origin,
                         const GroundSurface& ground, const SweepViewConfig& config) {
  const Eigen::Vector3d behind = origin + p * (1.0 + GroundSurface::kColumn / std::max(range, 0.1));
  const GroundSurface::Place place = ground.at(behind.x(), behind.y());
  return place.carried && is_obstacle_return(place.height - origin.z() - p.z(), p.z(), p.norm(), config);
}

std::vector<Keyed> collect(const MapPoints& points, const GroundSurface& ground, const SweepViewConfig& config) {
  std::vector<Keyed> returns;
  for (const Eigen::Vector3f& point : points.points) {
    const Eigen::Vector3d p = point.cast<double>() - points.origin;
    const double range2 = p.x() * p.x() + p.y() * p.y();
    if (range2 > config.max_range_m * config.max_range_m) continue;
    const double above = point.z() - ground.height_at(point.x(), point.y()), range = std::sqrt(range2);
    if (!is_obstacle_return(above, p.z(), p.norm(), config) &&
        !(p.z() < 0.0 && below_ground_behind(p, range, points.origin, ground, config))) {
      continue;
    }
    const int sector = polar::sector_of(static_cast<float>(p.x()), static_cast<float>(p.y()));
    returns.push_back({static_cast<std::uint64_t>(sector) << 32 | static_cast<std::uint64_t>(range / kUnit),
                       {point.x(), point.y(), static_cast<float>(range), static_cast<float>(p.z()),
                        static_cast<float>(above), sector}});
  }
  radix_sort_by_key(returns);
  return returns;
}

/// For each return, how many of its sector lie within `reach` units of it, itself included.
std::vector<std::uint32_t> count_around(const std::vector<Keyed>& returns, std::uint64_t reach) {
  std::vector<std::uint32_t> counts(returns.size());
  std::size_t begin = 0, end = 0;
  for (std::size_t i = 0; i < returns.size(); ++i) {
    // Sectors are further apart in the key than any reach.
    while (returns[begin].key + reach < returns[i].key) ++begin;
    while (end < returns.size() && returns[end].key <= returns[i].key + reach) ++end;
    counts[i] = static_cast<std::uint32_t>(end - begin);
  }
  return counts;
}

/// For each return, the greatest of the counts within `reach` units of it.
std::vector<std::uint32_t> greatest_around(const std::vector<Keyed>& returns, const std::vector<std::uint32_t>& counts,
                                           std::uint64_t reach) {
  std::vector<std::uint32_t> greatest(returns.size());
  std::vector<std::size_t> falling(returns.size());  // candidates, in order, their counts falling
  std::size_t front = 0, back = 0, end = 0;
  for (std::size_t i = 0; i < returns.size(); ++i) {
    for (; end < returns.size() && returns[end].key <= returns[i].key + reach; ++end) {
      while (back > front && counts[falling[back - 1]] <= counts[end]) --back;
      falling[back++] = end;
    }
    while (returns[falling[front]].key + reach < returns[i].key) ++front;
    greatest[i] = counts[falling[front]];
  }
  return greatest;
}

}  // namespace

bool is_obstacle_return(double above, double drop, double range, const SweepViewConfig& config) {
  const double sigma_up = config.range_sigma_m * std::fabs(drop) / range;
  const double threshold = std::max(config.climbable_step_m + config.range_sigma_m, 5.0 * sigma_up);
  return above > threshold && above <= config.body_height_m;
}

std::vector<ObstacleReturn> obstacle_returns(const MapPoints& points, const GroundSurface& ground,
                                             const SweepViewConfig& config) {
  const std::vector<Keyed> returns = collect(points, ground, config);
  const auto deviation = static_cast<std::uint64_t>(config.range_sigma_m / kUnit + 0.5);
  const std::vector<std::uint32_t> counts = count_around(returns, deviation);
  const std::vector<std::uint32_t> greatest = greatest_around(returns, counts, kNoiseDeviations * deviation);
  std::vector<ObstacleReturn> kept;
  kept.reserve(returns.size());
  for (std::size_t i = 0; i < returns.size(); ++i) {
    if (greatest[i] < kDominance * counts[i]) kept.push_back(returns[i].value);
  }
  return kept;
}

}  // namespace scanway
