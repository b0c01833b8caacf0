#include "modules/planner/core/body/body.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/math/repeatable.h"

namespace scanway::planning {
namespace {

constexpr double kHeadingStep = 2.0 * repeatable::kPi / kHeadings;
/// A turn of one heading is taken as so many short ones, each covered by the hull of its chords.
constexpr int kTurnParts = 64;

Polygon turned(const Polygon& polygon, double angle) {
  return placed(polygon, repeatable::cos(angle), repeatable::sin(angle), 0.0, 0.0);
}

double distance_to_edge(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  const Eigen::Vector2d edge = b - a;
  const double length2 = edge.squaredNorm();
  const double along = length2 > 0.0 ? std::clamp(-a.dot(edge) / length2, 0.0, 1.0) : 0.0;
  return (a + along * edge).norm();
}

/// Even-odd rule.
bool holds_origin(const Polygon& polygon) {
  bool inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d& a = polygon[i];
    const Eigen::Vector2d& b = polygon[(i + 1) % polygon.size()];
    if ((a.y() > 0.0) != (b.y() > 0.0) && a.x() + (b.x() - a.x()) * (-a.y() / (b.y() - a.y())) > 0.0) inside = !inside;
  }
  return inside;
}

/// The area that the edges of `from` cross on their straight way to `to`. What the body meets while it moves, it
/// either overlapped before or meets with an edge.
Spans crossed_by_edges(const Polygon& from, const Polygon& to, double stretch) {
  std::vector<Spans> parts;
  for (std::size_t i = 0; i < from.size(); ++i) {
    const std::size_t j = (i + 1) % from.size();
    Polygon points = {from[i], from[j], to[i], to[j]};
    // The arc between two chord ends lies within the chord and its stretched copy.
    if (stretch > 1.0)
      points.insert(points.end(), {from[i] * stretch, from[j] * stretch, to[i] * stretch, to[j] * stretch});
    // By so much the stretched copy reaches too far.
    parts.push_back(cells_under_hull(std::move(points), (stretch - 1.0) * std::max(from[i].norm(), from[j].norm())));
  }
  return join(parts);
}

/// With a corner more on each edge that has its point nearest to the origin between its ends: turning, what lies on
/// one side of that point moves outwards and what lies on the other moves inwards.
Polygon split_at_nearest(const Polygon& polygon) {
  Polygon result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d& a = polygon[i];
    const Eigen::Vector2d edge = polygon[(i + 1) % polygon.size()] - a;
    const double along = -a.dot(edge) / std::max(edge.squaredNorm(), 1e-12);
    result.push_back(a);
    if (along > 0.0 && along < 1.0) result.push_back(a + along * edge);
  }
  return result;
}

Spans turn_between(const Polygon& footprint, const Spans& standing, int heading) {
  std::vector<Spans> parts = {standing};
  const double part = kHeadingStep / kTurnParts;
  const double stretch = 1.0 / repeatable::cos(part / 2.0);
  for (int i = 0; i < kTurnParts; ++i) {
    const double angle = heading * kHeadingStep + i * part;
    parts.push_back(crossed_by_edges(turned(footprint, angle), turned(footprint, angle + part), stretch));
  }
  return join(parts);
}

}  // namespace

double angle_of(int heading) {
  const int signed_heading = heading > kHeadings / 2 ? heading - kHeadings : heading;
  return signed_heading * kHeadingStep;
}

Polygon placed(const Polygon& polygon, double cosine, double sine, double x, double y) {
  Polygon result;
  result.reserve(polygon.size());
  for (const auto& corner : polygon) {
    result.emplace_back(cosine * corner.x() - sine * corner.y() + x, sine * corner.x() + cosine * corner.y() + y);
  }
  return result;
}

Body::Body(const std::vector<Eigen::Vector2d>& footprint, double resolution_m) {
  for (const auto& corner : footprint) footprint_.push_back(corner / resolution_m);
  inscribed_ = holds_origin(footprint_) ? std::numeric_limits<double>::infinity() : 0.0;
  for (std::size_t i = 0; i < footprint_.size(); ++i) {
    circumscribed_ = std::max(circumscribed_, footprint_[i].norm());
    inscribed_ = std::min(inscribed_, distance_to_edge(footprint_[i], footprint_[(i + 1) % footprint_.size()]));
  }
  for (int heading = 0; heading < kHeadings; ++heading) {
    const Polygon here = turned(footprint_, heading * kHeadingStep);
    standing_[heading] = cells_under(here);
    turning_[heading] = turn_between(split_at_nearest(footprint_), standing_[heading], heading);
    for (int step = 0; step < kSteps; ++step) {
      const Polygon there = placed(here, 1.0, 0.0, kStepX[step], kStepY[step]);
      const Spans both = join({standing_[heading], moved(standing_[heading], kStepX[step], kStepY[step])});
      stepping_[heading][step] = without(crossed_by_edges(here, there, 1.0), both);
    }
  }
}

Spans Body::sweeping(double dx, double dy) const {
  const double length = std::sqrt(dx * dx + dy * dy);
  Polygon points = placed(footprint_, dx / length, dy / length, 0.0, 0.0);
  const Polygon there = placed(points, 1.0, 0.0, dx, dy);
  points.insert(points.end(), there.begin(), there.end());
  return cells_under_hull(std::move(points));
}

}  // namespace scanway::planning
