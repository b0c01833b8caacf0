#include "modules/mapper/core/assembly/support_line.h"

#include <vector>

namespace scanway {
namespace {

/// Whether b lies below the line from a to c.
bool is_below(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c) {
  return (b.y - a.y) * (c.x - a.x) < (c.y - a.y) * (b.x - a.x);
}

/// Andrew's monotone chain.
std::vector<PlanePoint> lower_hull(std::span<const PlanePoint> points) {
  std::vector<PlanePoint> hull;
  for (const PlanePoint& point : points) {
    while (hull.size() > 1 && !is_below(hull[hull.size() - 2], hull.back(), point)) hull.pop_back();
    hull.push_back(point);
  }
  return hull;
}

}  // namespace

std::optional<StraightLine> support_line(std::span<const PlanePoint> points) {
  if (points.size() < 2 || !(points.back().x > points.front().x)) return std::nullopt;
  double sum = 0.0;
  for (const PlanePoint& point : points) sum += point.x;
  const double mean = sum / static_cast<double>(points.size());
  const std::vector<PlanePoint> hull = lower_hull(points);
  std::size_t right = 1;
  while (right + 1 < hull.size() && hull[right].x < mean) ++right;
  const PlanePoint &a = hull[right - 1], &b = hull[right];
  return StraightLine{a, (b.y - a.y) / (b.x - a.x)};
}

}  // namespace scanway
