#include "modules/planner/core/path/clearance.h"

#include <algorithm>
#include <cmath>

#include "common/math/repeatable.h"

namespace scanway::planning {
namespace {

/// Distance between two segments' nearest points where they do not cross: an end of one is among them.
double distance_to_segment(const Eigen::Vector2d& p, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  const Eigen::Vector2d edge = b - a;
  const double length2 = edge.squaredNorm();
  const double along = length2 > 0.0 ? std::clamp((p - a).dot(edge) / length2, 0.0, 1.0) : 0.0;
  return (a + along * edge - p).norm();
}

double distance_to_square(const Eigen::Vector2d& p, Cell cell) {
  const double dx = std::max(std::fabs(p.x() - cell.x) - 0.5, 0.0);
  const double dy = std::max(std::fabs(p.y() - cell.y) - 0.5, 0.0);
  return std::sqrt(dx * dx + dy * dy);
}

/// Between a polygon and a cell's square that do not overlap, in cells.
double distance_to_cell(const Polygon& polygon, Cell cell) {
  double distance = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d& a = polygon[i];
    const Eigen::Vector2d& b = polygon[(i + 1) % polygon.size()];
    distance = std::min(distance, distance_to_square(a, cell));
    for (const double x : {-0.5, 0.5}) {
      for (const double y : {-0.5, 0.5})
        distance = std::min(distance, distance_to_segment({cell.x + x, cell.y + y}, a, b));
    }
  }
  return distance;
}

}  // namespace

Clearance::Clearance(const Terrain& terrain)
    : terrain_(&terrain),
      has_body_(terrain.options().mode == BodyMode::footprint),
      reach_(has_body_ ? terrain.body().circumscribed() : 0.0) {}

bool Clearance::add(const Eigen::Vector2d& at, double heading) {
  const double before = least_;
  polygon_ = {at};
  if (has_body_) {
    polygon_ = placed(terrain_->body().footprint(), repeatable::cos(heading), repeatable::sin(heading), at.x(), at.y());
  }
  const CellRectangle& bounds = terrain_->bounds();
  const double widest = reach_ + static_cast<double>(std::max(bounds.width(), bounds.height())) + 2.0;
  if (before != kNone) look(at, least_ + reach_ + 1.0);
  // Doubling the window until something is found; then only what may be nearer.
  for (double window = 16.0 + reach_; least_ == kNone && !none_; window *= 2.0) {
    look(at, window);
    none_ = least_ == kNone && window > widest;
  }
  if (before == kNone && !none_) look(at, least_ + reach_ + 1.0);
  return least_ < before;
}

void Clearance::look(const Eigen::Vector2d& at, double window) {
  const Frame& frame = terrain_->frame();
  const auto limit = [](double value, std::int32_t low, std::int32_t size) {
    return static_cast<std::int32_t>(std::clamp(value - low, 0.0, size - 1.0));
  };
  const std::int32_t y1 = limit(std::ceil(at.y() + window), frame.low.y, frame.height);
  const std::int32_t x0 = limit(std::floor(at.x() - window), frame.low.x, frame.width) >> 6;
  const std::int32_t x1 = limit(std::ceil(at.x() + window), frame.low.x, frame.width) >> 6;
  for (std::int32_t y = limit(std::floor(at.y() - window), frame.low.y, frame.height); y <= y1; ++y) {
    for (std::int32_t x = x0; x <= x1; ++x) {
      for (std::uint64_t word = terrain_->occupied().word(y, x); word != 0; word &= word - 1) {
        hold(at, {frame.low.x + x * 64 + __builtin_ctzll(word), frame.low.y + y});
      }
    }
  }
}

void Clearance::hold(const Eigen::Vector2d& at, Cell cell) {
  if (distance_to_square(at, cell) - reach_ >= least_) return;
  least_ = std::min(least_, distance_to_cell(polygon_, cell));
}

}  // namespace scanway::planning
