#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "common/grid/cost_map.h"
#include "common/time/utime.h"
#include "scanway/cost_map_index_t.hpp"
#include "scanway/cost_tile_t.hpp"

namespace scanway {

/// A version of the mapper's cost map that has arrived whole: what it changes in the version before.
struct ClosedVersion {
  std::int64_t version = 0;
  Utime utime = 0;
  std::int64_t digest = 0;  ///< Of the whole cost map, as the mapper closed it.
  double resolution_m = 0.0;
  double origin_x_m = 0.0;
  double origin_y_m = 0.0;
  std::map<Cell, std::optional<CostTile>> changes;  ///< By tile index; nothing where a tile went away.
};

/// Makes the planner's cost map equal to the mapper's: collects tiles until they are exactly those that an index names.
/// Tiles and indices may come in any order; a version that was overtaken by a newer one before it was whole is skipped.
class CostMapReplica {
 public:
  /// `digest` is the tile's as an object. Throws BadMessage when it is no tile.
  std::optional<ClosedVersion> add_tile(const cost_tile_t& tile, std::uint64_t digest);
  /// Throws BadMessage when the index contradicts itself.
  std::optional<ClosedVersion> add_index(const cost_map_index_t& index);

  /// Whether the newest version that was announced is here.
  bool up_to_date() const { return !announced_; }
  std::int64_t closed_version() const { return closed_version_; }  ///< 0 before the first.

 private:
  struct Arrived {
    std::int64_t version = 0;
    std::int64_t digest = 0;
    CostTile cells;
  };

  std::optional<ClosedVersion> close();
  bool holds(const cost_tile_entry_t& entry) const;

  std::optional<cost_map_index_t> announced_;  // The newest index, until its tiles are here.
  std::int64_t closed_version_ = 0;
  std::map<Cell, std::int64_t> closed_;  // Digest of each tile of the closed version.
  std::map<Cell, Arrived> arrived_;      // Tiles that no closed version holds yet, the newest of each.
};

/// `version` on top of the version before.
void apply(const ClosedVersion& version, CostMap& map);

}  // namespace scanway
