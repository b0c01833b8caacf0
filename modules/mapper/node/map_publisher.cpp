#include "modules/mapper/node/map_publisher.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "common/bus/channels.h"
#include "common/messages/codec.h"
#include "common/messages/cost_map_message.h"
#include "common/messages/digest.h"
#include "common/messages/objects.h"
#include "scanway/octomap_t.hpp"

namespace scanway {
namespace {

constexpr double kCubeSide = 4.0;  // metres: some ten thousand points indoors
constexpr const char* kOctomapKey = "map";

/// Where no point of a tile has an intensity, and some of another have, theirs is 0.
void add_point(cloud_tile_t& tile, const PointCloud& cloud, std::size_t i) {
  if (!cloud.intensity.empty()) {
    tile.intensity.resize(tile.x.size());
    tile.intensity.push_back(cloud.intensity[i]);
  }
  tile.x.push_back(cloud.points[i].x());
  tile.y.push_back(cloud.points[i].y());
  tile.z.push_back(cloud.points[i].z());
}

std::int32_t cube_index(double coordinate) { return static_cast<std::int32_t>(std::floor(coordinate / kCubeSide)); }

using Cube = std::tuple<std::int32_t, std::int32_t, std::int32_t>;

Cube cube_of(const Eigen::Vector3d& p) { return {cube_index(p.x()), cube_index(p.y()), cube_index(p.z())}; }

/// The cubes that may have points of a tile: a centroid can be rounded over its border.
std::vector<Cube> cubes_over(const VoxelCloud& cloud, VoxelCloud::TileNumber tile) {
  const Eigen::AlignedBox3d box = cloud.box_of(tile);
  const Eigen::Vector3d margin = Eigen::Vector3d::Constant(cloud.voxel_m());
  const auto [low_x, low_y, low_z] = cube_of(box.min() - margin);
  const auto [high_x, high_y, high_z] = cube_of(box.max() + margin);
  std::vector<Cube> cubes;
  for (std::int32_t x = low_x; x <= high_x; ++x) {
    for (std::int32_t y = low_y; y <= high_y; ++y) {
      for (std::int32_t z = low_z; z <= high_z; ++z) cubes.emplace_back(x, y, z);
    }
  }
  return cubes;
}

}  // namespace

void MapPublisher::publish(const Map& map, const MapChange& change, Utime utime) {
  const auto version = static_cast<std::int64_t>(change.version);
  publish_tiles(map.cost_map(), change, utime);
  close_version(map.cost_map(), version, utime);
  publish_cloud(map.cloud(), change, utime);
  publish_octomap(map.occupancy_tree(), version, utime);
}

void MapPublisher::publish_whole(const Map& map, Utime utime) {
  MapChange all;
  all.version = map.version();
  for (const auto& [tile, content] : map.cost_map().tiles) all.changed_tiles.push_back(tile);
  all.changed_cloud = map.cloud().tiles();
  publish(map, all, utime);
}

void MapPublisher::publish_tiles(const CostMap& map, const MapChange& change, Utime utime) {
  const auto version = static_cast<std::int64_t>(change.version);
  for (const Cell& tile : change.changed_tiles) {
    const auto found = map.tiles.find(tile);
    if (found == map.tiles.end()) {
      tiles_.erase(tile);
      continue;
    }
    const auto bytes = encode(to_message(tile, found->second, version, utime));
    const std::uint64_t name = publish_object(bus_, channel::kCostMapTile, bytes, tile_key(tile), version, utime);
    cost_tile_entry_t& entry = tiles_[tile];
    entry.tile_x = tile.x;
    entry.tile_y = tile.y;
    entry.map_version = version;
    entry.tile_digest = static_cast<std::int64_t>(name);
  }
}

void MapPublisher::close_version(const CostMap& map, std::int64_t version, Utime utime) {
  std::vector<cost_tile_entry_t> entries;
  for (const auto& [tile, entry] : tiles_) entries.push_back(entry);
  const cost_map_index_t index = close_map(map, version, utime, std::move(entries));
  cost_map_digest_ = index.map_digest;
  publish_object(bus_, channel::kCostMapIndex, encode(index), kCostMapIndexKey, version, utime);
}

/// Tiles and cubes do not share borders: the cubes over a tile that changed have points of others, too.
void MapPublisher::publish_cloud(const VoxelCloud& cloud, const MapChange& change, Utime utime) {
  std::map<Cube, cloud_tile_t> cubes;
  for (const VoxelCloud::TileNumber tile : change.changed_cloud) {
    for (const Cube& cube : cubes_over(cloud, tile)) cubes[cube];
  }
  for (const VoxelCloud::TileNumber tile : cloud.tiles()) {
    const std::vector<Cube> over = cubes_over(cloud, tile);
    if (std::none_of(over.begin(), over.end(), [&cubes](const Cube& cube) { return cubes.contains(cube); })) continue;
    const PointCloud points = cloud.centroids_of(tile);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto cube = cubes.find(cube_of(points.points[i].cast<double>()));
      if (cube != cubes.end()) add_point(cube->second, points, i);
    }
  }
  for (auto& [cube, content] : cubes) {
    if (content.x.empty() && !cubes_.contains(cube)) continue;
    content.voxel_m = cloud.voxel_m();
    publish_cube(cube, content, static_cast<std::int64_t>(change.version), utime);
  }
}

void MapPublisher::publish_cube(const Cube& cube, cloud_tile_t& tile, std::int64_t version, Utime utime) {
  std::tie(tile.cube[0], tile.cube[1], tile.cube[2]) = cube;
  tile.cube_side_m = kCubeSide;
  tile.npoints = static_cast<std::int32_t>(tile.x.size());
  if (!tile.intensity.empty()) tile.intensity.resize(tile.x.size());
  tile.nintensities = static_cast<std::int32_t>(tile.intensity.size());
  // Without time and version, so that a cube that did not change has the digest that it had.
  const std::uint64_t content = digest(encode(tile));
  if (std::exchange(cubes_[cube], content) == content) return;
  tile.utime = utime;
  tile.map_version = version;
  const std::string key = fmt::format("{},{},{}", tile.cube[0], tile.cube[1], tile.cube[2]);
  publish_object(bus_, channel::kCloudTile, encode(tile), key, version, utime);
}

void MapPublisher::publish_octomap(const OccupancyTree& tree, std::int64_t version, Utime utime) {
  octomap_t message{};
  message.utime = utime;
  message.map_version = version;
  message.octomap_resolution_m = tree.resolution_m();
  const std::string stream = tree.bt_bytes();
  message.bt_stream.assign(stream.begin(), stream.end());
  message.nbytes = static_cast<std::int32_t>(stream.size());
  publish_object(bus_, channel::kOctomap, encode(message), kOctomapKey, version, utime);
}

}  // namespace scanway
