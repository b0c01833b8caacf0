#include "modules/planner/core/body/spans.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace scanway::planning {
namespace {

/// What lies on a border between two cells belongs to neither, whatever the rounding of the corners.
constexpr double kTouch = 1e-6;

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Andrew's monotone chain; counter-clockwise.
Polygon hull_of(Polygon points) {
  std::sort(points.begin(), points.end(),
            [](const auto& a, const auto& b) { return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y()); });
  Polygon hull;
  const auto add_chain = [&hull](auto begin, auto end) {
    const std::size_t base = hull.size();
    for (auto point = begin; point != end; ++point) {
      while (hull.size() >= base + 2 && cross(hull.back() - hull[hull.size() - 2], *point - hull.back()) <= 0.0) {
        hull.pop_back();
      }
      hull.push_back(*point);
    }
    hull.pop_back();
  };
  if (points.size() < 3) return points;
  add_chain(points.begin(), points.end());
  add_chain(points.rbegin(), points.rend());
  return hull;
}

struct Interval {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  void hold(double x) {
    low = std::min(low, x);
    high = std::max(high, x);
  }
};

std::int32_t nearest_row(double y) { return static_cast<std::int32_t>(std::floor(y + 0.5)); }

/// What of the edge a-b lies in the slab [bottom, top].
void hold_clipped(Interval& interval, const Eigen::Vector2d& a, const Eigen::Vector2d& b, double bottom, double top) {
  const double low = std::max(bottom, std::min(a.y(), b.y()));
  const double high = std::min(top, std::max(a.y(), b.y()));
  if (low > high) return;
  const double rise = b.y() - a.y();
  if (std::fabs(rise) < 1e-12) {
    interval.hold(a.x());
    interval.hold(b.x());
    return;
  }
  interval.hold(a.x() + (b.x() - a.x()) * ((low - a.y()) / rise));
  interval.hold(a.x() + (b.x() - a.x()) * ((high - a.y()) / rise));
}

void add_interval(Spans& spans, std::int32_t y, const Interval& interval, double touch) {
  if (!(interval.low <= interval.high)) return;
  const auto x0 = static_cast<std::int32_t>(std::floor(interval.low + 0.5 + touch));
  const auto x1 = static_cast<std::int32_t>(std::ceil(interval.high - 0.5 - touch));
  if (x0 <= x1) spans.push_back({y, x0, x1});
}

/// The rows' slabs of a convex polygon are convex, so their width says all.
Spans under_convex(const Polygon& polygon, double touch) {
  Interval rows;
  for (const auto& corner : polygon) rows.hold(corner.y());
  Spans spans;
  for (std::int32_t y = nearest_row(rows.low); y <= nearest_row(rows.high); ++y) {
    Interval interval;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      hold_clipped(interval, polygon[i], polygon[(i + 1) % polygon.size()], y - 0.5 + touch, y + 0.5 - touch);
    }
    add_interval(spans, y, interval, touch);
  }
  return spans;
}

/// Where the line through the middle of a row is inside the polygon.
void add_inside_at_middle(Spans& spans, const Polygon& polygon, std::int32_t y) {
  std::vector<double> crossings;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d& a = polygon[i];
    const Eigen::Vector2d& b = polygon[(i + 1) % polygon.size()];
    if ((a.y() > y) == (b.y() > y)) continue;
    crossings.push_back(a.x() + (b.x() - a.x()) * ((y - a.y()) / (b.y() - a.y())));
  }
  std::sort(crossings.begin(), crossings.end());
  for (std::size_t i = 0; i + 1 < crossings.size(); i += 2)
    add_interval(spans, y, {crossings[i], crossings[i + 1]}, kTouch);
}

Spans normalised(Spans spans) {
  std::sort(spans.begin(), spans.end());
  Spans result;
  for (const Span& span : spans) {
    if (!result.empty() && result.back().y == span.y && span.x0 <= result.back().x1 + 1) {
      result.back().x1 = std::max(result.back().x1, span.x1);
    } else {
      result.push_back(span);
    }
  }
  return result;
}

}  // namespace

Spans cells_under(const Polygon& polygon) {
  Spans spans;
  Interval rows;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Spans edge = under_convex({polygon[i], polygon[(i + 1) % polygon.size()]}, kTouch);
    spans.insert(spans.end(), edge.begin(), edge.end());
    rows.hold(polygon[i].y());
  }
  for (std::int32_t y = nearest_row(rows.low); y <= nearest_row(rows.high); ++y)
    add_inside_at_middle(spans, polygon, y);
  return normalised(std::move(spans));
}

Spans cells_under_hull(Polygon points, double touch) {
  return under_convex(hull_of(std::move(points)), std::max(touch, kTouch));
}

Spans join(const std::vector<Spans>& parts) {
  Spans all;
  for (const Spans& part : parts) all.insert(all.end(), part.begin(), part.end());
  return normalised(std::move(all));
}

Spans without(const Spans& from, const Spans& taken) {
  Spans result;
  auto next = taken.begin();
  for (Span span : from) {
    while (next != taken.end() && (next->y < span.y || (next->y == span.y && next->x1 < span.x0))) ++next;
    for (auto cut = next; cut != taken.end() && cut->y == span.y && cut->x0 <= span.x1; ++cut) {
      if (cut->x0 > span.x0) result.push_back({span.y, span.x0, cut->x0 - 1});
      span.x0 = std::max(span.x0, cut->x1 + 1);
    }
    if (span.x0 <= span.x1) result.push_back(span);
  }
  return result;
}

Spans moved(Spans spans, std::int32_t dx, std::int32_t dy) {
  for (Span& span : spans) span = {span.y + dy, span.x0 + dx, span.x1 + dx};
  return spans;
}

}  // namespace scanway::planning
