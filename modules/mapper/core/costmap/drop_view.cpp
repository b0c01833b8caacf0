#include "modules/mapper/core/costmap/drop_view.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/math/repeatable.h"
#include "common/parallel/blocks.h"
#include "modules/mapper/core/costmap/polar.h"

namespace scanway {
namespace {

using polar::kBin;
using polar::kSectors;
using polar::sector_of;

constexpr double kFarDrop = 0.04;   // metres
constexpr double kEvenFall = 0.03;  // metres a metre
constexpr double kThrough = 0.02;   // metres below the ground: more than the ground's own error

}  // namespace

DropView::DropView(const MapPoints& points, const GroundSurface& ground, const SweepViewConfig& config)
    : config_(config),
      origin_(points.origin),
      bins_(static_cast<int>(config.max_range_m / kBin)),
      steepest_(repeatable::sin(config.climbable_slope) / repeatable::cos(config.climbable_slope)) {
  beams_.assign(static_cast<std::size_t>(kSectors) * bins_, {std::numeric_limits<float>::infinity(), 0, false, false});
  const double floor_band = config_.climbable_step_m + config_.range_sigma_m;
  for (const Eigen::Vector3f& point : points.points) {
    const Eigen::Vector3d p = point.cast<double>() - origin_;
    if (p.z() > 0.0) continue;
    const double range = std::max(std::sqrt(p.x() * p.x() + p.y() * p.y()), 1e-4);
    const int bin = std::min(static_cast<int>(range / kBin), bins_ - 1);
    const int sector = sector_of(static_cast<float>(p.x()), static_cast<float>(p.y()));
    Beam& beam = beams_[static_cast<std::size_t>(sector) * bins_ + bin];
    const auto slope = static_cast<float>(p.z() / range);
    const double above = point.z() - ground.height_at(point.x(), point.y());
    beam.on_ground |= std::fabs(above) <= floor_band;
    beam.into_pit |= above < -floor_band;
    if (slope < beam.slope) beam.slope = slope, beam.ends = static_cast<std::uint16_t>(bin);
  }
  follow_beams();
}

void DropView::follow_beams() {
  for_blocks(kSectors, 64, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t sector = begin; sector < end; ++sector) {
      Beam* beam = &beams_[sector * bins_];
      for (int bin = bins_ - 2; bin >= 0; --bin) {
        if (beam[bin + 1].slope >= beam[bin].slope) continue;
        beam[bin].slope = beam[bin + 1].slope;
        beam[bin].ends = beam[bin + 1].ends;
      }
    }
  });
}

DropView::Below DropView::below(std::size_t sector, int bin, double sensor_above) const {
  const Beam& beam = beams_[sector * bins_ + bin];
  const double range = (bin + 0.5) * kBin;
  if (!(beam.slope < 0.0f) || sensor_above + beam.slope * range > 0.0) return Below::nothing;
  const double depth = -(sensor_above + beam.slope * (beam.ends + 0.5) * kBin);
  const double noise = 5.0 * config_.range_sigma_m * std::min(1.0, static_cast<double>(-beam.slope));
  if (-beam.slope > steepest_ && depth > std::max(config_.climbable_step_m + config_.range_sigma_m, noise)) {
    return Below::drop;
  }
  const double gap = depth / -beam.slope;  // over which the ground may fall as it does everywhere
  if (depth > kFarDrop + kEvenFall * gap) return Below::far_drop;
  const double band = config_.climbable_step_m + config_.range_sigma_m;
  return depth > band || sensor_above + beam.slope * range < -kThrough ? Below::passed : Below::nothing;
}

DropView::Below DropView::below(double x, double y, double ground_height) const {
  const double dx = x - origin_.x(), dy = y - origin_.y();
  const int here = static_cast<int>(std::sqrt(dx * dx + dy * dy) / kBin);
  const double sensor_above = origin_.z() - ground_height;
  const auto sector = static_cast<std::size_t>(sector_of(static_cast<float>(dx), static_cast<float>(dy)));
  Below most = Below::nothing;
  for (int bin = here; bin <= here + static_cast<int>(kEdge / kBin) && bin < bins_; ++bin) {
    Below around = Below::nothing;
    bool on_ground = false;
    for (const std::size_t step : {kSectors - 1, 0, 1}) {
      const std::size_t other = (sector + step) % kSectors;
      const Beam& beam = beams_[other * bins_ + bin];
      on_ground = on_ground || (beam.on_ground && !beam.into_pit);
      around = std::max(around, below(other, bin, sensor_above));
    }
    if (!on_ground && (bin == here || around >= Below::far_drop)) most = std::max(most, around);
  }
  return most;
}

}  // namespace scanway
