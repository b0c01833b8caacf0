#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "common/grid/cost_map.h"
#include "common/robot/robot.h"

namespace scanway {

using TileCosts = std::array<std::uint32_t, CostTile::kCells>;

/// The paper's costs, a tile at a time. What they are: embodiment.h.
class PaperCosts {
 public:
  static constexpr int kReach = 5;  ///< Cells along an axis: exp(-6^2 / 2) rounds to nothing.

  PaperCosts();

  /// False, and nothing written, when there is no obstacle within reach of the tile: all its costs are 0.
  bool of_tile(const CostMap& map, Cell tile, TileCosts& costs) const;

 private:
  static constexpr int kRows = 2 * kReach + 1;
  static constexpr int kStride = 12;                     // a row and a zero: three vectors of four
  std::array<std::uint32_t, kRows * kStride> kernel_{};  ///< In 2^-24ths, from -kReach.
};

/// The footprint's costs, a rectangle of tiles at a time: large ones spend less on what is around them.
class FootprintCosts {
 public:
  FootprintCosts(const Robot& robot, double resolution_m);

  int reach() const { return reach_; }  ///< Cells.

  struct Tile {
    Cell index;
    TileCosts costs;
  };
  /// All tiles from `first` to `last`, or none when there is no obstacle within their reach: all costs are 0.
  std::vector<Tile> of_tiles(const CostMap& map, Cell first, Cell last) const;

 private:
  int reach_;
  std::vector<std::uint32_t> by_squared_distance_;
};

}  // namespace scanway
