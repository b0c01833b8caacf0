#pragma once

#include <cstdint>
#include <map>
#include <tuple>

#include "common/bus/bus.h"
#include "common/time/utime.h"
#include "modules/mapper/core/map.h"
#include "scanway/cloud_tile_t.hpp"
#include "scanway/cost_tile_entry_t.hpp"

namespace scanway {

/// Publishes the products of a map, each time only what changed: COST_MAP_TILE, then COST_MAP_INDEX which closes the
/// version, CLOUD_TILE, OCTOMAP. All carry the time of the sweep that made the change.
class MapPublisher {
 public:
  /// `bus` must outlive this.
  explicit MapPublisher(Bus& bus) : bus_(bus) {}

  void publish(const Map& map, const MapChange& change, Utime utime);
  /// All of a map that was not published before, as the version that it has.
  void publish_whole(const Map& map, Utime utime);

  /// Of the last version that was closed: the digest of the whole cost map; 0 before the first.
  std::int64_t cost_map_digest() const { return cost_map_digest_; }

 private:
  using Cube = std::tuple<std::int32_t, std::int32_t, std::int32_t>;

  void publish_tiles(const CostMap& map, const MapChange& change, Utime utime);
  void close_version(const CostMap& map, std::int64_t version, Utime utime);
  void publish_cloud(const VoxelCloud& cloud, const MapChange& change, Utime utime);
  void publish_cube(const Cube& cube, cloud_tile_t& tile, std::int64_t version, Utime utime);
  void publish_octomap(const OccupancyTree& tree, std::int64_t version, Utime utime);

  Bus& bus_;
  std::map<Cell, cost_tile_entry_t> tiles_;
  std::map<Cube, std::uint64_t> cubes_;  // Digest of each cube's points, as last published.
  std::int64_t cost_map_digest_ = 0;
};

}  // namespace scanway
