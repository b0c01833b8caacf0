#include "tests/modules/planner/support/polygon_check.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <sstream>

namespace scanway::test {
namespace {

using planning::PathPose;

constexpr double kRounding = 2e-4;

/// Whether a convex polygon and the square of side 1 about `middle` overlap by more than rounding.
bool overlaps(const std::vector<Eigen::Vector2d>& polygon, const Eigen::Vector2d& middle) {
  const auto overlap_along = [&](const Eigen::Vector2d& axis) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const auto& corner : polygon) {
      low = std::min(low, axis.dot(corner - middle));
      high = std::max(high, axis.dot(corner - middle));
    }
    const double half = 0.5 * (std::fabs(axis.x()) + std::fabs(axis.y()));
    return low < half - kRounding && high > -half + kRounding;
  };
  if (!overlap_along({1.0, 0.0}) || !overlap_along({0.0, 1.0})) return false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d edge = polygon[(i + 1) % polygon.size()] - polygon[i];
    if (!overlap_along(Eigen::Vector2d(-edge.y(), edge.x()).normalized())) return false;
  }
  return true;
}

}  // namespace

PolygonCheck::PolygonCheck(const TestMap& map, const Robot& robot)
    : bounds_(map.bounds),
      resolution_m_(map.map.resolution_m),
      origin_m_(map.map.origin_x_m, map.map.origin_y_m),
      unknown_blocks_(robot.planning.unknown == UnknownPolicy::never) {
  for (const auto& corner : robot.body.footprint) footprint_.push_back(corner / resolution_m_);
  for (const auto& corner : footprint_) reach_ = std::max(reach_, corner.norm());
  for (std::int32_t y = bounds_.low.y; y < bounds_.high.y; ++y) {
    for (std::int32_t x = bounds_.low.x; x < bounds_.high.x; ++x) {
      const CellState state = map.map.state({x, y});
      blocked_.push_back(state == CellState::occupied || (state == CellState::unknown && unknown_blocks_));
    }
  }
}

bool PolygonCheck::blocks(Cell cell) const {
  if (!bounds_.contains(cell)) return unknown_blocks_;
  return blocked_[static_cast<std::size_t>((cell.y - bounds_.low.y) * bounds_.width() + cell.x - bounds_.low.x)];
}

bool PolygonCheck::hits(const Eigen::Vector2d& at, double heading) const {
  const double c = std::cos(heading), s = std::sin(heading);
  std::vector<Eigen::Vector2d> polygon;
  for (const auto& corner : footprint_) {
    polygon.push_back(at + Eigen::Vector2d(c * corner.x() - s * corner.y(), s * corner.x() + c * corner.y()));
  }
  const int reach = static_cast<int>(std::ceil(reach_)) + 1;
  const auto x0 = static_cast<std::int32_t>(std::floor(at.x() + 0.5));
  const auto y0 = static_cast<std::int32_t>(std::floor(at.y() + 0.5));
  for (int y = y0 - reach; y <= y0 + reach; ++y) {
    for (int x = x0 - reach; x <= x0 + reach; ++x) {
      if (blocks({x, y}) && overlaps(polygon, Eigen::Vector2d(x, y))) return true;
    }
  }
  return false;
}

bool PolygonCheck::hits_at(double x_m, double y_m, double heading) const {
  return hits((Eigen::Vector2d(x_m, y_m) - origin_m_) / resolution_m_ - Eigen::Vector2d(0.5, 0.5), heading);
}

std::string PolygonCheck::first_hit(const std::vector<PathPose>& path) const {
  for (std::size_t i = 0; i < path.size(); ++i) {
    const PathPose& from = path[i == 0 ? 0 : i - 1];
    const PathPose& to = path[i];
    const double turn = std::remainder(to.heading - from.heading, 2.0 * std::numbers::pi);
    const double way = std::hypot(to.x_m - from.x_m, to.y_m - from.y_m) / resolution_m_;
    const int parts = 1 + static_cast<int>(2.0 * (way + reach_ * std::fabs(turn)));
    for (int part = 0; part <= parts; ++part) {
      const double t = static_cast<double>(part) / parts;
      const double x = from.x_m + t * (to.x_m - from.x_m), y = from.y_m + t * (to.y_m - from.y_m);
      if (!hits_at(x, y, from.heading + t * turn)) continue;
      std::ostringstream words;
      words << "pose " << i << " of " << path.size() << " at " << x << ", " << y << ", " << from.heading + t * turn;
      return words.str();
    }
  }
  return {};
}

}  // namespace scanway::test
