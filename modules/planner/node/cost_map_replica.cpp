#include "modules/planner/node/cost_map_replica.h"

#include <algorithm>
#include <utility>

#include "common/messages/cost_map_message.h"

namespace scanway {
namespace {

Cell tile_of(const cost_tile_entry_t& entry) { return {entry.tile_x, entry.tile_y}; }

}  // namespace

std::optional<ClosedVersion> CostMapReplica::add_tile(const cost_tile_t& tile, std::uint64_t digest) {
  if (tile.map_version <= closed_version_) return std::nullopt;
  Arrived& arrived = arrived_[{tile.tile_x, tile.tile_y}];
  if (tile.map_version < arrived.version) return std::nullopt;
  arrived = {tile.map_version, static_cast<std::int64_t>(digest), to_cost_tile(tile)};
  return close();
}

std::optional<ClosedVersion> CostMapReplica::add_index(const cost_map_index_t& index) {
  check_index(index);
  if (index.map_version <= closed_version_) return std::nullopt;
  if (announced_ && index.map_version < announced_->map_version) return std::nullopt;
  announced_ = index;
  return close();
}

bool CostMapReplica::holds(const cost_tile_entry_t& entry) const {
  const auto closed = closed_.find(tile_of(entry));
  if (closed != closed_.end() && closed->second == entry.tile_digest) return true;
  const auto arrived = arrived_.find(tile_of(entry));
  return arrived != arrived_.end() && arrived->second.digest == entry.tile_digest;
}

std::optional<ClosedVersion> CostMapReplica::close() {
  if (!announced_) return std::nullopt;
  const auto& entries = announced_->tiles;
  if (!std::all_of(entries.begin(), entries.end(), [this](const auto& entry) { return holds(entry); })) {
    return std::nullopt;
  }
  ClosedVersion version;
  version.version = announced_->map_version;
  version.utime = announced_->utime;
  version.digest = announced_->map_digest;
  version.resolution_m = announced_->resolution_m;
  version.origin_x_m = announced_->map_origin_m[0];
  version.origin_y_m = announced_->map_origin_m[1];
  std::map<Cell, std::int64_t> before = std::exchange(closed_, {});
  for (const cost_tile_entry_t& entry : entries) {
    const Cell tile = tile_of(entry);
    closed_[tile] = entry.tile_digest;
    const auto known = before.find(tile);
    if (known == before.end() || known->second != entry.tile_digest) version.changes[tile] = arrived_.at(tile).cells;
    before.erase(tile);
  }
  for (const auto& [tile, digest] : before) version.changes[tile] = std::nullopt;
  closed_version_ = version.version;
  std::erase_if(arrived_, [&](const auto& arrived) { return arrived.second.version <= closed_version_; });
  announced_.reset();
  return version;
}

void apply(const ClosedVersion& version, CostMap& map) {
  map.resolution_m = version.resolution_m;
  map.origin_x_m = version.origin_x_m;
  map.origin_y_m = version.origin_y_m;
  for (const auto& [tile, cells] : version.changes) {
    if (cells) {
      map.tiles[tile] = *cells;
    } else {
      map.tiles.erase(tile);
    }
  }
}

}  // namespace scanway
