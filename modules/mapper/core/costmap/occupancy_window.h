#pragma once

#include <cstdint>
#include <vector>

#include "common/grid/cost_map.h"

namespace scanway {

/// The occupied cells of a rectangle of the map, one byte a cell, row by row.
struct OccupancyWindow {
  Cell corner;  ///< The lowest cell.
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> occupied;  ///< 1 or 0.
  bool any = false;

  /// The cells [corner, corner + (width, height)) of `map`.
  static OccupancyWindow of(const CostMap& map, Cell corner, int width, int height);
};

}  // namespace scanway
