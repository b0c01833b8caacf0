#include <algorithm>
#include <array>
#include <cmath>

#include "common/math/repeatable.h"
#include "modules/mapper/core/ground/column_offsets.h"
#include "modules/mapper/core/ground/ground_surface.h"

/// The plane that carries each column, and heights where there is none.
namespace scanway {
namespace {

constexpr double kSlopeBeside = 0.1;      // metres a metre: what ground on one side of a step may rise towards it
constexpr std::size_t kSlopeSamples = 4;  // of fewer a slope is not known
constexpr double kMaxDisagreeing = 0.1;   // of the points around: stray returns do not take the floor away
constexpr int kFillRings = 50;            // columns: how far a height is carried over to where there is no ground
constexpr double kHeightUnit = 1e-4;      // metres

}  // namespace

/// Points of ground about a column's centre, one a joined column around, the nearest first.
struct GroundSurface::Samples {
  std::array<Eigen::Vector3d, 64> points;
  std::array<double, 64> weights;
  std::size_t count = 0;

  void add(const Eigen::Vector3d& point, double weight) {
    weights[count] = weight;
    points[count++] = point;
  }
  Plane plane() const {
    PlaneSums sums;
    for (std::size_t i = 0; i < count; ++i) sums.add(points[i]);
    return sums.plane();
  }
  /// Whether nearly all points lie within `limit` of the plane.
  bool agree(const Plane& plane, double limit) const {
    double disagreeing = 0.0, all = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
      all += weights[i];
      if (std::fabs(points[i].z() - plane.at(points[i].x(), points[i].y())) > limit) disagreeing += weights[i];
    }
    return disagreeing <= kMaxDisagreeing * all;
  }
  /// Those that lie as the nearest does, but for a slope.
  Samples beside_nearest(double limit) const {
    Samples kept;
    for (std::size_t i = 0; i < count; ++i) {
      const double away = (points[i] - points[0]).head<2>().norm();
      if (std::fabs(points[i].z() - points[0].z()) <= limit + kSlopeBeside * away) kept.add(points[i], weights[i]);
    }
    return kept;
  }
};

GroundSurface::Samples GroundSurface::samples_around(int cx, int cy) const {
  Samples samples;
  const Column& here = columns_[index(cx, cy)];
  const auto take = [&](int x, int y) {
    if (!inside(cx + x, cy + y)) return;
    const Column& c = columns_[index(cx + x, cy + y)];
    if (!c.joined) return;
    const bool beyond_step = here.step ? std::abs(mean(index(cx + x, cy + y)) - here.lower) > band_
                                       : c.step || stepped_between(cx, cy, cx + x, cy + y);
    if (beyond_step) return;
    const double points = c.count;
    samples.add({(x - 0.5) * kColumn + c.x_sum / points * kHeightUnit,
                 (y - 0.5) * kColumn + c.y_sum / points * kHeightUnit, c.u_sum / points * kHeightUnit},
                std::min(points, 100.0));
  };
  static const std::vector<Eigen::Vector2i> kReachable = offsets_within(kReach);
  take(0, 0);
  for (const Eigen::Vector2i& offset : kReachable) take(offset.x(), offset.y());
  return samples;
}

std::optional<GroundSurface::Plane> GroundSurface::carrying_plane(const Samples& all) const {
  const double step = config_.climbable_step_m + config_.range_sigma_m;
  if (all.count < 2) return std::nullopt;
  Samples samples = all;
  Plane plane = samples.plane();
  if (!samples.agree(plane, step / 2)) {
    const Samples beside = samples.beside_nearest(step / 2);
    if (beside.count >= 2 && beside.agree(beside.plane(), step / 2)) samples = beside, plane = beside.plane();
  }
  if (!samples.agree(plane, step)) return std::nullopt;
  const double slope_x = plane_.slope_x + plane.a, slope_y = plane_.slope_y + plane.b;
  const double gradient = std::sqrt(slope_x * slope_x + slope_y * slope_y);
  if (repeatable::atan2(gradient, 1.0) > config_.climbable_slope) return std::nullopt;
  return plane;
}

GroundSurface::Plane GroundSurface::ahead_of(std::size_t column) const {
  const Samples samples = samples_around(static_cast<int>(column % side_), static_cast<int>(column / side_));
  std::optional<Plane> plane;
  if (samples.count >= kSlopeSamples) plane = carrying_plane(samples);
  return plane.value_or(Plane{0.0, 0.0, mean(column) * kHeightUnit});
}

void GroundSurface::fit_column(int cx, int cy) {
  const Samples samples = samples_around(cx, cy);
  Column& column = columns_[index(cx, cy)];
  column.support = static_cast<std::uint8_t>(samples.count);
  if (column.step) {  // Also where nothing carries: what returns from above it is no ground.
    column.carried = samples.count >= 2;
    column.height = static_cast<float>(column.lower * kHeightUnit);
    return;
  }
  const std::optional<Plane> plane = carrying_plane(samples);
  if (!plane) return;
  column.carried = true;
  column.height = static_cast<float>(plane->c);
  column.slope_x = static_cast<float>(plane->a);
  column.slope_y = static_cast<float>(plane->b);
}

void GroundSurface::fill_outwards() {
  std::vector<std::size_t> front;
  std::vector<bool> known(columns_.size());
  for (std::size_t c = 0; c < columns_.size(); ++c) {
    known[c] = columns_[c].carried || columns_[c].step;
    if (columns_[c].carried) front.push_back(c);
  }
  for (int ring = 0; ring < kFillRings && !front.empty(); ++ring) {
    std::vector<std::size_t> next;
    for (const std::size_t c : front) {
      const int cx = static_cast<int>(c % side_), cy = static_cast<int>(c / side_);
      for (const Eigen::Vector2i& step : {Eigen::Vector2i(1, 0), {-1, 0}, {0, 1}, {0, -1}}) {
        const int x = cx + step.x(), y = cy + step.y();
        if (!inside(x, y) || known[index(x, y)]) continue;
        known[index(x, y)] = true;
        columns_[index(x, y)].height = columns_[c].height;
        next.push_back(index(x, y));
      }
    }
    front.swap(next);
  }
}

}  // namespace scanway
