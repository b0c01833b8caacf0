#include "modules/mapper/core/overlap.h"

#include <algorithm>
#include <utility>

#include "modules/mapper/core/registration/agreement.h"
#include "modules/mapper/core/registration/prepared_scan.h"

namespace scanway {
namespace {

constexpr std::size_t kSamples = 500;      // points a side
constexpr std::size_t kMostCompared = 12;  // the nearest: scans of a place are taken from places near it
constexpr double kLeastOverlap = 0.3;      // below, few registrations are accepted

/// Both ways: the smaller share of one's points that has a point of the other within 0.3 m.
double overlap(const PlacedSweep& sweep, const PlacedSweep& target, const Pose& X_map_sweep) {
  const Pose T_target_sweep = target.X_map_sweep.inverse() * X_map_sweep;
  const PreparedScan::Data &from = sweep.scan.data(), &to = target.scan.data();
  const Pose T = Eigen::Translation3d(-to.origin) * T_target_sweep * Eigen::Translation3d(from.origin);
  const registration::Agreement agreement = registration::assess(from, to, T, kSamples);
  return std::min(agreement.overlap, agreement.overlap_back);
}

using Ranked = std::vector<std::pair<double, std::size_t>>;  // Highest first; of equals the newer sweep.

void keep_best(Ranked& ranked, std::size_t count) {
  std::sort(ranked.rbegin(), ranked.rend());
  if (ranked.size() > count) ranked.resize(count);
}

/// The sweeps nearest to a place, without those that are withdrawn.
Ranked nearest_to(const Eigen::Vector3d& place, const std::vector<PlacedSweep>& map, std::size_t count) {
  Ranked nearest;
  for (std::size_t i = 0; i < map.size(); ++i) {
    if (map[i].withdrawn) continue;
    nearest.emplace_back(-(map[i].X_map_sweep * map[i].origin - place).norm(), i);
  }
  keep_best(nearest, count);
  return nearest;
}

std::vector<std::size_t> numbers_of(const Ranked& ranked) {
  std::vector<std::size_t> numbers;
  for (const auto& [rank, number] : ranked) numbers.push_back(number);
  return numbers;
}

}  // namespace

std::vector<std::size_t> nearest_to_last(const std::vector<PlacedSweep>& map, std::size_t count) {
  const PlacedSweep& last =
      *std::find_if(map.rbegin(), map.rend(), [](const PlacedSweep& sweep) { return !sweep.withdrawn; });
  return numbers_of(nearest_to(last.X_map_sweep * last.origin, map, count));
}

std::vector<std::size_t> most_overlapping(const PlacedSweep& sweep, const Pose& X_map_sweep,
                                          const std::vector<PlacedSweep>& map, std::size_t count) {
  Ranked most;
  for (const auto& [rank, i] : nearest_to(X_map_sweep * sweep.origin, map, kMostCompared)) {
    const double share = overlap(sweep, map[i], X_map_sweep);
    if (share >= kLeastOverlap) most.emplace_back(share, i);
  }
  keep_best(most, count);
  return numbers_of(most);
}

}  // namespace scanway
