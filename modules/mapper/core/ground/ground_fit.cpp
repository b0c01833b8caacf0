#include <algorithm>
#include <array>
#include <cmath>

#include "common/math/repeatable.h"
#include "modules/mapper/core/ground/column_offsets.h"
#include "modules/mapper/core/ground/ground_surface.h"

/// The plane that carries each column, and heights where there is none.
namespace scanway {
namespace {

constexpr double kShrinkage = 0.01;      // m^2: draws a fitted slope towards the ground plane's where points are few
constexpr double kMaxDisagreeing = 0.1;  // of the points around: stray returns do not take the floor away
constexpr int kFillRings = 50;           // columns: how far a height is carried over to where there is no ground
constexpr double kHeightUnit = 1e-4;     // metres

}  // namespace

/// Points of ground about a column's centre, one a joined column around.
struct GroundSurface::Samples {
  std::array<Eigen::Vector3d, 64> points;
  std::array<double, 64> weights;
  std::size_t count = 0;

  void add(const Eigen::Vector3d& point, double weight) {
    weights[count] = weight;
    points[count++] = point;
  }
  /// u = c + a x + b y, each sample counting the same.
  struct Plane {
    double a, b, c;
    double at(const Eigen::Vector3d& p) const { return c + a * p.x() + b * p.y(); }
  };
  Plane plane() const {
    double n = 0.0, x1 = 0.0, y1 = 0.0, u1 = 0.0, xx = 0.0, xy = 0.0, yy = 0.0, xu = 0.0, yu = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
      const Eigen::Vector3d& p = points[i];
      n += 1.0, x1 += p.x(), y1 += p.y(), u1 += p.z();
      xx += p.x() * p.x(), xy += p.x() * p.y(), yy += p.y() * p.y(), xu += p.x() * p.z(), yu += p.y() * p.z();
    }
    const double sxx = xx - x1 * x1 / n + kShrinkage, syy = yy - y1 * y1 / n + kShrinkage, sxy = xy - x1 * y1 / n;
    const double sxu = xu - x1 * u1 / n, syu = yu - y1 * u1 / n;
    const double determinant = sxx * syy - sxy * sxy;
    const double a = (sxu * syy - syu * sxy) / determinant, b = (syu * sxx - sxu * sxy) / determinant;
    return {a, b, (u1 - a * x1 - b * y1) / n};
  }
  /// Whether nearly all points lie within `limit` of the plane.
  bool agree(const Plane& plane, double limit) const {
    double disagreeing = 0.0, all = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
      all += weights[i];
      if (std::fabs(points[i].z() - plane.at(points[i])) > limit) disagreeing += weights[i];
    }
    return disagreeing <= kMaxDisagreeing * all;
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

void GroundSurface::fit_column(int cx, int cy) {
  const Samples samples = samples_around(cx, cy);
  Column& column = columns_[index(cx, cy)];
  column.support = static_cast<std::uint8_t>(samples.count);
  if (samples.count < 2) return;
  if (column.step) {
    column.carried = true;
    column.height = static_cast<float>(column.lower * kHeightUnit);
    return;
  }
  const Samples::Plane plane = samples.plane();
  if (!samples.agree(plane, config_.climbable_step_m + config_.range_sigma_m)) return;
  const double slope_x = plane_.slope_x + plane.a, slope_y = plane_.slope_y + plane.b;
  const double gradient = std::sqrt(slope_x * slope_x + slope_y * slope_y);
  if (repeatable::atan2(gradient, 1.0) > config_.climbable_slope) return;
  column.carried = true;
  column.height = static_cast<float>(plane.c);
  column.slope_x = static_cast<float>(plane.a);
  column.slope_y = static_cast<float>(plane.b);
}

void GroundSurface::fill_outwards() {
  std::vector<std::size_t> front;
  std::vector<bool> known(columns_.size());
  for (std::size_t c = 0; c < columns_.size(); ++c) {
    known[c] = columns_[c].carried;
    if (known[c]) front.push_back(c);
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
