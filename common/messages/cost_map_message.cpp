#include "common/messages/cost_map_message.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <tuple>
#include <utility>

#include "common/messages/codec.h"
#include "common/messages/digest.h"

namespace scanway {

namespace {

// Beyond these no robot goes, and numbers of cells no longer fit in 32 bits.
constexpr double kFinest = 1e-4, kCoarsest = 1e3;  // metres
constexpr double kFarthest = 1e7;                  // metres
constexpr std::int64_t kFarthestTile = 1 << 22;

bool is_near(double coordinate) { return coordinate >= -kFarthest && coordinate <= kFarthest; }

auto place(const cost_tile_entry_t& tile) { return std::tuple(tile.tile_x, tile.tile_y); }

std::int64_t digest_of(cost_map_index_t index) {
  index.utime = 0;
  index.map_digest = 0;
  return static_cast<std::int64_t>(digest(encode(index)));
}

}  // namespace

std::string tile_key(Cell tile) { return std::to_string(tile.x) + "," + std::to_string(tile.y); }

cost_tile_t to_message(Cell tile, const CostTile& cells, std::int64_t map_version, Utime utime) {
  cost_tile_t message{};
  message.utime = utime;
  message.tile_x = tile.x;
  message.tile_y = tile.y;
  message.map_version = map_version;
  message.side_cells = CostTile::kSide;
  message.ncells = static_cast<std::int32_t>(CostTile::kCells);
  message.cell_state.resize(CostTile::kCells);
  message.cell_cost.resize(CostTile::kCells);
  for (std::size_t i = 0; i < CostTile::kCells; ++i) {
    message.cell_state[i] = static_cast<std::uint8_t>(cells.state[i]);
    message.cell_cost[i] = static_cast<std::int32_t>(cells.cost[i]);
  }
  return message;
}

CostTile to_cost_tile(const cost_tile_t& message) {
  if (message.side_cells != CostTile::kSide || message.cell_state.size() != CostTile::kCells) {
    throw BadMessage("a cost tile of " + std::to_string(message.side_cells) + " cells a side");
  }
  CostTile tile;
  for (std::size_t i = 0; i < CostTile::kCells; ++i) {
    if (message.cell_state[i] > static_cast<std::uint8_t>(CellState::occupied)) {
      throw BadMessage("a cost tile with a cell in state " + std::to_string(message.cell_state[i]));
    }
    tile.state[i] = static_cast<CellState>(message.cell_state[i]);
    tile.cost[i] = static_cast<std::uint32_t>(message.cell_cost[i]);
  }
  return tile;
}

cost_map_index_t close_map(const CostMap& map, std::int64_t map_version, Utime utime,
                           std::vector<cost_tile_entry_t> tiles) {
  std::sort(tiles.begin(), tiles.end(), [](const auto& a, const auto& b) { return place(a) < place(b); });
  cost_map_index_t index{};
  index.utime = utime;
  index.map_version = map_version;
  index.resolution_m = map.resolution_m;
  index.map_origin_m[0] = map.origin_x_m;
  index.map_origin_m[1] = map.origin_y_m;
  index.ntiles = static_cast<std::int32_t>(tiles.size());
  index.tiles = std::move(tiles);
  index.map_digest = digest_of(index);
  return index;
}

void check_index(const cost_map_index_t& index) {
  const bool is_scaled = index.resolution_m >= kFinest && index.resolution_m <= kCoarsest;
  if (!is_scaled) throw BadMessage("a cost map whose resolution is absurd");
  if (!is_near(index.map_origin_m[0]) || !is_near(index.map_origin_m[1])) {
    throw BadMessage("a cost map whose origin is absurd");
  }
  const bool in_reach = std::all_of(index.tiles.begin(), index.tiles.end(), [](const cost_tile_entry_t& tile) {
    return std::abs(std::int64_t{tile.tile_x}) <= kFarthestTile && std::abs(std::int64_t{tile.tile_y}) <= kFarthestTile;
  });
  if (!in_reach) throw BadMessage("a cost map with a tile out of all reach");
  const auto disorder = std::adjacent_find(index.tiles.begin(), index.tiles.end(),
                                           [](const auto& a, const auto& b) { return place(a) >= place(b); });
  if (disorder != index.tiles.end()) throw BadMessage("a cost map whose tiles are out of order");
  if (digest_of(index) != index.map_digest) throw BadMessage("a cost map index whose digest is not its own");
}

}  // namespace scanway
