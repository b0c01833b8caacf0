#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <map>

namespace scanway {

/// What is known of a cell. Never anything between: unknown is not free.
enum class CellState : std::uint8_t { unknown = 0, free = 1, occupied = 2 };

/// A cell by its index: cell (x, y) covers [x, x + 1) x [y, y + 1) times the map's resolution, from the map's origin.
struct Cell {
  std::int32_t x = 0;
  std::int32_t y = 0;
  auto operator<=>(const Cell&) const = default;
};

/// Costs are in 2^-24ths: kCostOne is the paper's f(x, y) at the obstacle itself. kCostLethal: the robot's centre
/// cannot be here at any heading.
constexpr std::uint32_t kCostOne = 1u << 24;
constexpr std::uint32_t kCostLethal = 0xFFFFFFFFu;

/// A square of cells. Tile (x, y) holds the cells [x * kSide, (x + 1) * kSide) x [y * kSide, (y + 1) * kSide),
/// row by row from its lowest y.
struct CostTile {
  static constexpr std::int32_t kSide = 128;
  static constexpr std::size_t kCells = static_cast<std::size_t>(kSide) * kSide;
  std::array<CellState, kCells> state{};
  std::array<std::uint32_t, kCells> cost{};
  bool operator==(const CostTile&) const = default;
};

/// The map of cells that the planner plans on: tiles where anything is known, unknown and without cost elsewhere.
/// x right, y up, in metres of the map frame from (origin_x_m, origin_y_m), the corner of cell (0, 0).
struct CostMap {
  double resolution_m = 0.01;
  double origin_x_m = 0.0;
  double origin_y_m = 0.0;
  std::map<Cell, CostTile> tiles;  ///< By tile index.

  CellState state(Cell cell) const;
  std::uint32_t cost(Cell cell) const;
  void set_state(Cell cell, CellState state);
  void set_cost(Cell cell, std::uint32_t cost);
  /// The tile that a cell lies in.
  static Cell tile_of(Cell cell);
  /// A cell's index within its tile's arrays.
  static std::size_t index_in_tile(Cell cell);
};

}  // namespace scanway
