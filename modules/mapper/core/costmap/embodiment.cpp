#include "modules/mapper/core/costmap/embodiment.h"

#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <utility>

#include "common/parallel/blocks.h"
#include "modules/mapper/core/costmap/tile_costs.h"

namespace scanway {
namespace {

constexpr std::int32_t kBlock = 4;  // tiles along the edge of a square that is computed at once

std::int32_t block_of(std::int32_t tile) { return (tile >= 0 ? tile : tile - kBlock + 1) / kBlock; }

/// Tiles of one square.
using Block = std::vector<Cell>;

/// The tiles within reach of the touched ones, by squares.
std::vector<Block> blocks_in_reach(const std::vector<Cell>& touched, int reach) {
  const std::int32_t around = (reach + CostTile::kSide - 1) / CostTile::kSide;
  std::map<Cell, std::set<Cell>> by_block;
  for (const Cell& tile : touched) {
    for (std::int32_t y = tile.y - around; y <= tile.y + around; ++y) {
      for (std::int32_t x = tile.x - around; x <= tile.x + around; ++x) {
        by_block[{block_of(x), block_of(y)}].insert({x, y});
      }
    }
  }
  std::vector<Block> blocks;
  for (const auto& [index, tiles] : by_block) blocks.emplace_back(tiles.begin(), tiles.end());
  return blocks;
}

/// What one square's tiles became.
struct BlockResult {
  std::vector<Cell> changed;
  std::vector<std::pair<Cell, std::unique_ptr<TileCosts>>> made;  ///< Costs where there is no tile yet.
};

/// `costs` null: nothing costs. Touches no other tile, so that squares may be done side by side.
void write(CostMap& map, Cell index, const TileCosts* costs, BlockResult& result) {
  static const TileCosts kNone{};
  const auto known = map.tiles.find(index);
  const TileCosts& now = costs != nullptr ? *costs : kNone;
  if (known == map.tiles.end()) {
    if (now != kNone) result.made.emplace_back(index, std::make_unique<TileCosts>(now));
  } else if (known->second.cost != now) {
    known->second.cost = now;
    result.changed.push_back(index);
  }
}

BlockResult embody_block(CostMap& map, const Block& block, const PaperCosts& paper) {
  BlockResult result;
  const auto costs = std::make_unique_for_overwrite<TileCosts>();
  for (const Cell& tile : block) write(map, tile, paper.of_tile(map, tile, *costs) ? costs.get() : nullptr, result);
  return result;
}

BlockResult embody_block(CostMap& map, const Block& block, const FootprintCosts& footprint) {
  Cell first = block.front(), last = block.front();
  for (const Cell& tile : block) {
    first = {std::min(first.x, tile.x), std::min(first.y, tile.y)};
    last = {std::max(last.x, tile.x), std::max(last.y, tile.y)};
  }
  BlockResult result;
  const std::vector<FootprintCosts::Tile> tiles = footprint.of_tiles(map, first, last);
  for (const Cell& index : block) {
    const auto at = std::find_if(tiles.begin(), tiles.end(), [&](const auto& tile) { return tile.index == index; });
    write(map, index, at != tiles.end() ? &at->costs : nullptr, result);
  }
  return result;
}

template <class Costs>
std::vector<BlockResult> embody_blocks(CostMap& map, const std::vector<Block>& blocks, const Costs& costs) {
  std::vector<BlockResult> results(blocks.size());
  for_blocks(blocks.size(), 1, [&](std::size_t begin, std::size_t, std::size_t) {
    results[begin] = embody_block(map, blocks[begin], costs);
  });
  return results;
}

void remove_if_empty(CostMap& map, Cell index) {
  const auto tile = map.tiles.find(index);
  if (tile == map.tiles.end()) return;
  const auto is_unknown = [](CellState state) { return state == CellState::unknown; };
  const auto is_zero = [](std::uint32_t cost) { return cost == 0; };
  const auto& [states, costs] = tile->second;
  if (std::all_of(states.begin(), states.end(), is_unknown) && std::all_of(costs.begin(), costs.end(), is_zero)) {
    map.tiles.erase(tile);
  }
}

}  // namespace

std::vector<Cell> embody(CostMap& map, const Robot& robot, Embodiment embodiment, const std::vector<Cell>& touched) {
  std::vector<BlockResult> results;
  if (embodiment == Embodiment::paper) {
    results = embody_blocks(map, blocks_in_reach(touched, PaperCosts::kReach), PaperCosts());
  } else {
    const FootprintCosts footprint(robot, map.resolution_m);
    results = embody_blocks(map, blocks_in_reach(touched, footprint.reach()), footprint);
  }
  std::set<Cell> changed(touched.begin(), touched.end());
  for (const BlockResult& result : results) {
    for (const auto& [index, costs] : result.made) {
      map.tiles[index].cost = *costs;
      changed.insert(index);
    }
    changed.insert(result.changed.begin(), result.changed.end());
  }
  for (const Cell& index : changed) remove_if_empty(map, index);
  return {changed.begin(), changed.end()};
}

void embody(CostMap& map, const Robot& robot, Embodiment embodiment) {
  std::vector<Cell> all;
  for (const auto& [index, tile] : map.tiles) all.push_back(index);
  embody(map, robot, embodiment, all);
}

}  // namespace scanway
