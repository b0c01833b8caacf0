#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Core>

#include "common/grid/cost_map.h"

namespace scanway::planning {

/// The cell that holds a point; cell (x, y) is the square of side 1 about the point (x, y).
inline Cell cell_of(const Eigen::Vector2d& point) {
  return {static_cast<std::int32_t>(std::floor(point.x() + 0.5)),
          static_cast<std::int32_t>(std::floor(point.y() + 0.5))};
}

/// Calls visit(cell, share) for the cells that the segment a-b passes, in order, with the share of its length that lies
/// in each (Amanatides and Woo, Eurographics 1987). From a cell's middle to another's exact: where the segment meets a
/// corner of four cells, it goes from one straight to the one across.
template <class Visit>
void for_cells_on(const Eigen::Vector2d& a, const Eigen::Vector2d& b, Visit&& visit) {
  const Eigen::Vector2d way = b - a;
  const std::int32_t step_x = way.x() < 0.0 ? -1 : 1, step_y = way.y() < 0.0 ? -1 : 1;
  const auto border = [](double from, double along, std::int32_t cell, std::int32_t step) {
    return along == 0.0 ? std::numeric_limits<double>::infinity() : (cell + 0.5 * step - from) / along;
  };
  Cell cell = cell_of(a);
  for (double t = 0.0; t < 1.0;) {
    const double x = border(a.x(), way.x(), cell.x, step_x), y = border(a.y(), way.y(), cell.y, step_y);
    const double next = std::min({x, y, 1.0});
    visit(cell, std::max(0.0, next - t));
    if (x <= next) cell.x += step_x;
    if (y <= next) cell.y += step_y;
    t = std::max(t, next);
  }
}

}  // namespace scanway::planning
