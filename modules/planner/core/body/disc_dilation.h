#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "modules/planner/core/body/bit_grid.h"

namespace scanway::planning {

/// 64 x 64 cells, a word a row.
using Block = std::array<std::uint64_t, 64>;

/// Which cells have a set cell nearer to their middle than a radius: the distance is to the nearest point of the set
/// cell's square, and one at the radius itself is not nearer. For two radii at once.
class DiscDilation {
 public:
  /// Radii in cells, `small` <= `large`.
  DiscDilation(double small, double large);

  struct Result {
    Block small;
    Block large;
  };
  /// For the block whose lowest row is `row` (a multiple of 64) and whose word column is `column`.
  Result around(const BitGrid& grid, std::int32_t row, std::int32_t column) const;

  /// Cells further apart than this, in x or y, do not matter to one another.
  std::int32_t reach() const { return reach_; }

 private:
  void widen(const BitGrid& grid, std::int32_t row, std::int32_t column, std::vector<std::uint64_t>& by_width) const;

  std::int32_t reach_;
  std::vector<std::int32_t> small_;  ///< Half width of the disc's row at distance |dy|; -1: none.
  std::vector<std::int32_t> large_;
};

}  // namespace scanway::planning
