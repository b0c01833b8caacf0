#pragma once

#include <cmath>
#include <cstdint>
#include <optional>

#include "common/grid/bounds.h"

namespace scanway::planning {

inline double distance(Cell a, Cell b) {
  const double x = a.x - b.x, y = a.y - b.y;
  return std::sqrt(x * x + y * y);
}

/// The cell nearest to `middle` that `is_one`: ring by ring, until no further one can be nearer.
template <class IsOne>
std::optional<Cell> nearest(const CellRectangle& bounds, Cell middle, const IsOne& is_one) {
  const auto widest = static_cast<std::int32_t>(bounds.width() + bounds.height());
  std::optional<Cell> found;
  const auto try_cell = [&](Cell cell) {
    const bool nearer = !found || distance(cell, middle) < distance(*found, middle);
    if (bounds.contains(cell) && nearer && is_one(cell)) found = cell;
  };
  for (std::int32_t ring = 0; ring <= widest && !(found && distance(*found, middle) <= ring); ++ring) {
    for (std::int32_t i = -ring; i <= ring; ++i) {
      try_cell({middle.x + i, middle.y - ring});
      try_cell({middle.x + i, middle.y + ring});
      try_cell({middle.x - ring, middle.y + i});
      try_cell({middle.x + ring, middle.y + i});
    }
  }
  return found;
}

}  // namespace scanway::planning
