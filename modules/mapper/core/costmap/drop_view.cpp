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
constexpr int kEdgeBins = static_cast<int>(DropView::kEdge / kBin);
constexpr double kBend = 0.015;  // metres a metre: what the ground may bend away from its slope here

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

/// How far below the ground as it goes on a beam ended.
double DropView::depth(const Beam& beam, int bin, const Profile& ground) const {
  return ground.height + ground.least_rise * ((beam.ends - bin) * kBin) - beam.slope * ((beam.ends + 0.5) * kBin);
}

DropView::Below DropView::below(const Beam& beam, int bin, const Profile& ground) const {
  if (!(beam.slope < 0.0f)) return Below::nothing;
  const double deep = depth(beam, bin, ground), gap = (beam.ends - bin) * kBin;
  const double sigma_up = config_.range_sigma_m * std::min(1.0, static_cast<double>(-beam.slope));
  const double noise = std::max(config_.climbable_step_m + 3.0 * sigma_up, 5.0 * sigma_up);
  if (deep <= noise + kBend * gap) return Below::nothing;
  if (-beam.slope > steepest_ && deep > config_.climbable_step_m + config_.range_sigma_m) return Below::drop;
  return deep > kFarDrop + kEvenFall * deep / -beam.slope ? Below::far_drop : Below::unsure;
}

bool DropView::any_falls(const polar::Place& place, const Profile& ground) const {
  const int last = std::min(place.bin + kEdgeBins, bins_ - 1);
  for (int step = -1; step <= 1; ++step) {
    const Beam* beams = &beam(place.sector + step, 0);
    for (int bin = place.bin; bin <= last; ++bin) {
      if (depth(beams[bin], bin, ground) > config_.climbable_step_m) return true;
    }
  }
  return false;
}

DropView::Below DropView::below_around(const polar::Place& place, const Profile& ground) const {
  Below deepest = Below::nothing;
  for (int bin = place.bin; bin <= place.bin + kEdgeBins && bin < bins_; ++bin) {
    Below around = Below::nothing;
    int doubts = 0;  // One alone may be a stray return.
    bool on_ground = false;
    for (const int step : {-1, 0, 1}) {
      const Beam& passing = beam(place.sector + step, bin);
      on_ground = on_ground || (passing.on_ground && !passing.into_pit);
      const Below one = below(passing, bin, ground);
      doubts += one == Below::nothing ? 0 : 1;
      const bool passed_below = passing.slope * (bin + 0.5) * kBin < ground.height;
      // Before the edge is passed all must agree that there is one.
      const int needed = passed_below ? 1 : 3;
      if (one >= Below::far_drop ? doubts >= needed : doubts > 1) around = std::max(around, one);
    }
    if (!on_ground && (bin == place.bin || around >= Below::far_drop)) deepest = std::max(deepest, around);
  }
  return deepest;
}

DropView::Way DropView::way(const polar::Place& place, const Eigen::Vector2d& direction,
                            const GroundSurface::Place& ground) const {
  if (place.bin >= bins_) return {};
  const double rise = (ground.slope_x * direction.x() + ground.slope_y * direction.y()) / place.range;
  const double plane_rise = (plane_.slope_x * direction.x() + plane_.slope_y * direction.y()) / place.range;
  // Near a wall's foot the local slope is not to be trusted.
  const Profile profile{ground.height - origin_.z(), std::min(rise, plane_rise)};
  int least_gap = bins_;
  for (const int step : {-1, 0, 1}) {
    const Beam& passing = beam(place.sector + step, place.bin);
    least_gap = std::min(least_gap, passing.ends - passing.begins);
  }
  Way way;
  if (any_falls(place, profile)) way.below = below_around(place, profile);
  way.sparse = least_gap > static_cast<int>(kSparse / kBin) || -profile.height < kGrazing * place.range;
  return way;
}

}  // namespace scanway
