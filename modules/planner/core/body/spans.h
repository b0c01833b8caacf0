#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace scanway::planning {

/// Cells [x0, x1] of row y, relative to the cell that the robot's centre is in the middle of.
struct Span {
  std::int32_t y = 0;
  std::int32_t x0 = 0;
  std::int32_t x1 = 0;
  auto operator<=>(const Span&) const = default;
};

/// Ordered by row and column, no two of them touching.
using Spans = std::vector<Span>;

/// Corners in cells; cell (x, y) is the square of side 1 about the point (x, y).
using Polygon = std::vector<Eigen::Vector2d>;

/// The cells that the area of a polygon overlaps (one that it only touches is not overlapped). Exact but for 1e-6 of a
/// cell. The polygon need not be convex.
Spans cells_under(const Polygon& polygon);

/// The same for the convex hull of `points`; a cell that is overlapped by less than `touch` does not count.
Spans cells_under_hull(Polygon points, double touch = 0.0);

/// The cells of any of them.
Spans join(const std::vector<Spans>& parts);

/// The cells of `from` that are not in `taken`.
Spans without(const Spans& from, const Spans& taken);

/// The same cells, moved.
Spans moved(Spans spans, std::int32_t dx, std::int32_t dy);

}  // namespace scanway::planning
