#pragma once

#include <optional>

#include "common/grid/cost_map.h"

namespace scanway {

/// A rectangle of cells: from `low` up to and without `high`.
struct CellRectangle {
  Cell low;
  Cell high;

  std::int64_t width() const { return std::int64_t{high.x} - low.x; }
  std::int64_t height() const { return std::int64_t{high.y} - low.y; }
  bool contains(Cell cell) const { return cell.x >= low.x && cell.y >= low.y && cell.x < high.x && cell.y < high.y; }
  bool operator==(const CellRectangle&) const = default;
};

/// The smallest rectangle that holds all known cells; nothing when no cell is known.
std::optional<CellRectangle> bounds(const CostMap& map);

}  // namespace scanway
