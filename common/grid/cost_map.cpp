#include "common/grid/cost_map.h"

namespace scanway {
namespace {

constexpr std::int32_t floor_divide(std::int32_t a, std::int32_t b) { return a / b - (a % b < 0 ? 1 : 0); }

}  // namespace

Cell CostMap::tile_of(Cell cell) {
  return {floor_divide(cell.x, CostTile::kSide), floor_divide(cell.y, CostTile::kSide)};
}

std::size_t CostMap::index_in_tile(Cell cell) {
  const Cell tile = tile_of(cell);
  const auto column = static_cast<std::size_t>(cell.x - tile.x * CostTile::kSide);
  const auto row = static_cast<std::size_t>(cell.y - tile.y * CostTile::kSide);
  return row * CostTile::kSide + column;
}

CellState CostMap::state(Cell cell) const {
  const auto tile = tiles.find(tile_of(cell));
  return tile == tiles.end() ? CellState::unknown : tile->second.state[index_in_tile(cell)];
}

std::uint32_t CostMap::cost(Cell cell) const {
  const auto tile = tiles.find(tile_of(cell));
  return tile == tiles.end() ? 0 : tile->second.cost[index_in_tile(cell)];
}

void CostMap::set_state(Cell cell, CellState state) { tiles[tile_of(cell)].state[index_in_tile(cell)] = state; }

void CostMap::set_cost(Cell cell, std::uint32_t cost) { tiles[tile_of(cell)].cost[index_in_tile(cell)] = cost; }

}  // namespace scanway
