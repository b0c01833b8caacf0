#include "modules/mapper/core/costmap/sweep_view.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "common/parallel/blocks.h"
#include "modules/mapper/core/cloud/radix_sort.h"
#include "modules/mapper/core/costmap/polar.h"

namespace scanway {
namespace {

using polar::kBin;
using polar::kSectors;
using polar::sector_of;

constexpr double kSparseDepth = 0.5;  // metres behind an obstacle's return: the rows on a table top are this far apart
constexpr double kLookOver = 0.3;     // metres: the sensor looks over what is this far below it
constexpr double kLeaning = 0.04;     // metres a metre, against all the ground
constexpr double kMaxSpacing = 0.15;  // metres
constexpr float kNoBeam = std::numeric_limits<float>::infinity();

/// Median distance to the nearest neighbour, over about 2,000 returns from 1 to 8 m.
double median_spacing(const MapPoints& points) {
  struct Entry {
    std::uint64_t key;
    Eigen::Vector3f p;
  };
  const auto key_of = [](const Eigen::Vector3f& p, int dx, int dy, int dz) {
    const auto index = [](float v, int d) {
      return static_cast<std::uint64_t>(std::floor(v / kMaxSpacing) + 100000.0 + d);
    };
    return index(p.x(), dx) << 42 | index(p.y(), dy) << 21 | index(p.z(), dz);
  };
  std::vector<Entry> entries;
  const Eigen::Vector3f origin = points.origin.cast<float>();
  for (const Eigen::Vector3f& point : points.points) {
    const Eigen::Vector3f p = point - origin;
    const float range2 = p.x() * p.x() + p.y() * p.y() + p.z() * p.z();
    if (range2 > 1.0f && range2 < 64.0f) entries.push_back({key_of(p, 0, 0, 0), p});
  }
  radix_sort_by_key(entries);
  std::vector<float> nearest;
  const std::size_t stride = std::max<std::size_t>(1, entries.size() / 2000);
  for (std::size_t i = 0; i < entries.size(); i += stride) {
    float best = static_cast<float>(kMaxSpacing * kMaxSpacing);
    for (int n = 0; n < 27; ++n) {
      const std::uint64_t key = key_of(entries[i].p, n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1);
      auto at = std::lower_bound(entries.begin(), entries.end(), key,
                                 [](const Entry& entry, std::uint64_t k) { return entry.key < k; });
      for (; at != entries.end() && at->key == key; ++at) {
        if (&*at == &entries[i]) continue;
        const Eigen::Vector3f d = at->p - entries[i].p;
        best = std::min(best, d.x() * d.x() + d.y() * d.y() + d.z() * d.z());
      }
    }
    nearest.push_back(best);
  }
  if (nearest.empty()) return kMaxSpacing;
  std::nth_element(nearest.begin(), nearest.begin() + nearest.size() / 2, nearest.end());
  return std::sqrt(nearest[nearest.size() / 2]);
}

}  // namespace

SweepView::SweepView(const MapPoints& points, const std::vector<Eigen::Vector3f>& missing, const GroundSurface& ground,
                     const std::vector<ObstacleReturn>& obstacles, const SweepViewConfig& config)
    : config_(config),
      origin_(points.origin),
      plane_(ground.plane()),
      spacing_(median_spacing(points)),
      bins_(static_cast<int>(config.max_range_m / kBin)) {
  lowest_.assign(static_cast<std::size_t>(kSectors) * bins_, kNoBeam);
  hidden_.assign(lowest_.size(), -kNoBeam);
  add_beams(points, ground);
  add_missing(missing, origin_.z() - ground.height_at(origin_.x(), origin_.y()));
  pass_on();
  hide_behind(obstacles);
  look_around();
}

void SweepView::add_beams(const MapPoints& points, const GroundSurface& ground) {
  const double floor_band = config_.climbable_step_m + config_.range_sigma_m;
  for (const Eigen::Vector3f& point : points.points) {
    const Eigen::Vector3d p = point.cast<double>() - origin_;
    const double range = std::max(std::sqrt(p.x() * p.x() + p.y() * p.y()), 1e-4);
    const int bin = std::min(static_cast<int>(range / kBin), bins_ - 1);
    const auto slope = static_cast<float>(p.z() / range);
    const int sector = sector_of(static_cast<float>(p.x()), static_cast<float>(p.y()));
    float& lowest = lowest_[static_cast<std::size_t>(sector) * bins_ + bin];
    if (slope >= lowest || point.z() - ground.height_at(point.x(), point.y()) < -floor_band) continue;
    lowest = slope;
  }
}

void SweepView::add_missing(const std::vector<Eigen::Vector3f>& directions, double sensor_above) {
  for (const Eigen::Vector3f& d : directions) {
    const auto slope = static_cast<float>(d.z() / std::max(std::sqrt(d.x() * d.x() + d.y() * d.y()), 1e-4f));
    const double range = slope < 0.0f ? std::min(kMissingRange, sensor_above / -slope) : kMissingRange;
    const int last = std::clamp(static_cast<int>(range / kBin), 0, bins_ - 1);
    float& lowest = lowest_[static_cast<std::size_t>(sector_of(d.x(), d.y())) * bins_ + last];
    lowest = std::min(lowest, slope);
  }
}

/// What passed over a bin passed over all before it.
void SweepView::pass_on() {
  for_blocks(kSectors, 64, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t sector = begin; sector < end; ++sector) {
      float* lowest = &lowest_[sector * bins_];
      for (int bin = bins_ - 2; bin >= 0; --bin) lowest[bin] = std::min(lowest[bin], lowest[bin + 1]);
    }
  });
}

void SweepView::hide_behind(const std::vector<ObstacleReturn>& obstacles) {
  std::vector<std::int32_t> edges(hidden_.size() + 1, 0);  // +1 where a wholly hidden stretch begins, -1 behind its end
  for (const ObstacleReturn& obstacle : obstacles) {
    const double sensor_above = obstacle.above - obstacle.from_sensor;
    // By similar triangles: where the beam, had it gone on, would have come down to the step.
    const double landing = obstacle.from_sensor < 0.0f
                               ? obstacle.range * (sensor_above - config_.climbable_step_m) / -obstacle.from_sensor
                               : config_.max_range_m;
    const bool tall = obstacle.from_sensor >= -kLookOver || obstacle.above >= config_.body_height_m - kLookOver;
    const double end = std::min({landing, tall ? landing : obstacle.range + kSparseDepth, config_.max_range_m - kBin});
    const int first = std::min(static_cast<int>(obstacle.range / kBin), bins_ - 1);
    const int last = std::max(first, static_cast<int>(end / kBin));
    const std::size_t sector = static_cast<std::size_t>(obstacle.sector) * bins_;
    if (tall) {
      ++edges[sector + first], --edges[sector + last + 1];
      continue;
    }
    for (int bin = first; bin <= last; ++bin) {
      hidden_[sector + bin] = std::max(hidden_[sector + bin], obstacle.from_sensor);
    }
  }
  std::int32_t open = 0;  // every stretch ends in its own sector
  for (std::size_t i = 0; i < hidden_.size(); ++i) {
    if ((open += edges[i]) > 0) hidden_[i] = kNoBeam;
  }
}

void SweepView::look_around() {
  // A lateral distance spans fewer sectors the further out: bins_to_look[d] is where it no longer spans d of them.
  std::vector<int> bins_to_look;
  for (int d = 0; d <= kSectors / 4; ++d) {
    const double range = 0.75 * spacing_ / ((d - 0.5) * polar::kSectorWidth);
    bins_to_look.push_back(d <= 1 ? bins_ : std::min(static_cast<int>(range / kBin + 0.5), bins_));
    if (bins_to_look.back() == 0) break;
  }
  std::vector<float> lowest(lowest_.size());
  std::vector<float> hidden(hidden_.size(), -kNoBeam);
  const int reach = static_cast<int>(bins_to_look.size()) - 1;
  for_blocks(kSectors, 64, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t sector = begin; sector < end; ++sector) {
      float* least = &lowest[sector * bins_];
      float* top = &hidden[sector * bins_];
      std::fill(least, least + bins_, kNoBeam);
      for (int d = -reach; d <= reach; ++d) {
        const std::size_t other = (sector + kSectors + d) % kSectors * bins_;
        const int bins = bins_to_look[static_cast<std::size_t>(std::abs(d))];
        for (int bin = 0; bin < bins; ++bin) least[bin] = std::min(least[bin], lowest_[other + bin]);
        for (int bin = 0; bin < bins; ++bin) top[bin] = std::max(top[bin], hidden_[other + bin]);
      }
    }
  });
  lowest_.swap(lowest);
  hidden_.swap(hidden);
}

bool SweepView::leans(const GroundSurface::Place& ground) const {
  const double x = ground.slope_x - plane_.slope_x, y = ground.slope_y - plane_.slope_y;
  return x * x + y * y > kLeaning * kLeaning;
}

bool SweepView::seen_empty(const polar::Place& place, const GroundSurface::Place& ground) const {
  if (place.bin >= bins_) return false;
  const std::size_t at = static_cast<std::size_t>(place.sector) * bins_ + place.bin;
  const double sensor_above = origin_.z() - ground.height;
  const double step = config_.climbable_step_m + config_.range_sigma_m;
  // A slab that leans on the ground is carried like a ramp; all that its edge returns hides it.
  if (hidden_[at] > (leans(ground) ? -kNoBeam : step - sensor_above)) return false;
  const double beam_above = sensor_above + lowest_[at] * place.range - 0.5 * config_.divergence * place.range;
  // The next return of a thinned floor is up to 1.5 steps further out; its beam passes here that much higher.
  const double thinned = 1.5 * spacing_ * sensor_above / std::max(place.range, kBin);
  return beam_above <= std::min(step + thinned, config_.body_height_m);
}

}  // namespace scanway
