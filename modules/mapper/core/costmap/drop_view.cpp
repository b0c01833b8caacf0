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
constexpr double kGrazing = 0.1;    // of a sight line's slope: a step of 3 cm hides 30 cm behind it
constexpr double kEvenFall = 0.02;  // metres a metre: what even ground may fall away
constexpr double kBend = 0.015;     // metres a metre: what the ground may bend away from its slope here

}  // namespace

DropView::DropView(const MapPoints& points, const GroundSurface& ground, const SweepViewConfig& config)
    : config_(config),
      origin_(points.origin),
      plane_(ground.plane()),
      bins_(static_cast<int>(config.max_range_m / kBin)),
      steepest_(repeatable::sin(config.climbable_slope) / repeatable::cos(config.climbable_slope)) {
  beams_.assign(static_cast<std::size_t>(kSectors) * bins_,
                {std::numeric_limits<float>::infinity(), 0, 0, false, false});
  add_returns(points, ground);
  follow_beams();
}

void DropView::add_returns(const MapPoints& points, const GroundSurface& ground) {
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
      std::uint16_t last = 0;
      for (int bin = 0; bin < bins_; ++bin) {
        if (beam[bin].on_ground) last = static_cast<std::uint16_t>(bin);
        beam[bin].begins = last;
      }
    }
  });
}

DropView::Below DropView::below(const Beam& beam, int bin, const Profile& ground) const {
  if (!(beam.slope < 0.0f)) return Below::nothing;
  const double end = (beam.ends + 0.5) * kBin, gap = end - (bin + 0.5) * kBin;
  const double depth = ground.height + ground.least_rise * gap - beam.slope * end;
  const double sigma_up = config_.range_sigma_m * std::min(1.0, static_cast<double>(-beam.slope));
  const double noise = std::max(config_.climbable_step_m + 3.0 * sigma_up, 5.0 * sigma_up);
  if (depth <= noise + kBend * gap) return Below::nothing;
  if (-beam.slope > steepest_ && depth > config_.climbable_step_m + config_.range_sigma_m) return Below::drop;
  return depth > kFarDrop + kEvenFall * depth / -beam.slope ? Below::far_drop : Below::unsure;
}

DropView::Way DropView::way(double x, double y, const GroundSurface::Place& place) const {
  const double dx = x - origin_.x(), dy = y - origin_.y();
  const double range = std::max(std::sqrt(dx * dx + dy * dy), 1e-4);
  const int here = static_cast<int>(range / kBin);
  const double rise = (place.slope_x * dx + place.slope_y * dy) / range;
  const double plane_rise = (plane_.slope_x * dx + plane_.slope_y * dy) / range;
  // Near a wall's foot the local slope is not to be trusted.
  const Profile ground{place.height - origin_.z(), std::min(rise, plane_rise)};
  const auto sector = static_cast<std::size_t>(sector_of(static_cast<float>(dx), static_cast<float>(dy)));
  Way way;
  int least_gap = bins_;
  for (int bin = here; bin <= here + static_cast<int>(kEdge / kBin) && bin < bins_; ++bin) {
    Below around = Below::nothing;
    int doubts = 0;  // One alone may be a stray return.
    bool on_ground = false;
    for (const std::size_t step : {kSectors - 1, 0, 1}) {
      const Beam& beam = beams_[(sector + step) % kSectors * bins_ + bin];
      on_ground = on_ground || (beam.on_ground && !beam.into_pit);
      const Below one = below(beam, bin, ground);
      doubts += one == Below::nothing ? 0 : 1;
      const bool passed_below = beam.slope * (bin + 0.5) * kBin < ground.height;
      // Before the edge is passed all must agree that there is one.
      const int needed = passed_below ? 1 : 3;
      if (one >= Below::far_drop ? doubts >= needed : doubts > 1) around = std::max(around, one);
      if (bin == here) least_gap = std::min(least_gap, beam.ends - beam.begins);
    }
    if (!on_ground && (bin == here || around >= Below::far_drop)) way.below = std::max(way.below, around);
  }
  way.sparse = least_gap > static_cast<int>(kSparse / kBin) || -ground.height < kGrazing * range;
  return way;
}

}  // namespace scanway
