#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "common/grid/cost_map.h"
#include "common/time/utime.h"
#include "scanway/cost_map_index_t.hpp"
#include "scanway/cost_tile_t.hpp"

namespace scanway {

/// A tile's key on COST_MAP_TILE: "x,y".
std::string tile_key(Cell tile);
/// The index's key on COST_MAP_INDEX.
constexpr const char* kCostMapIndexKey = "index";

cost_tile_t to_message(Cell tile, const CostTile& cells, std::int64_t map_version, Utime utime);
/// Throws BadMessage unless side, states and counts are those of a CostTile.
CostTile to_cost_tile(const cost_tile_t& message);

/// Closes a version of `map`; `tiles` in any order. The message's map_digest covers all but utime.
cost_map_index_t close_map(const CostMap& map, std::int64_t map_version, Utime utime,
                           std::vector<cost_tile_entry_t> tiles);
/// Throws BadMessage unless the tiles are in order, once each, the resolution is positive and the digest right.
void check_index(const cost_map_index_t& index);

}  // namespace scanway
