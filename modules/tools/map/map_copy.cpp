#include "modules/tools/map/map_copy.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <utility>

#include "common/bus/channels.h"
#include "common/messages/codec.h"
#include "common/messages/cost_map_message.h"
#include "common/octree/octree_file.h"

namespace scanway::tools {
namespace {

bool is_same_voxel(double a, double b) { return std::abs(a - b) < 1e-6; }

std::string sentence(const std::string& what, const ListedObjects& objects, const std::string& parts) {
  if (!objects.is_listed()) return what + ": not heard of yet";
  return fmt::format("{} version {}: {} of {} {} here", what, objects.version(), objects.size() - objects.lacking(),
                     objects.size(), parts);
}

}  // namespace

MapCopy::MapCopy(Bus& bus, const MapDetail& detail) : detail_(detail) {
  subscribe(bus, channel::kCostMapTile, tile_input_, cost_map_);
  subscribe(bus, channel::kCloudLevel, cloud_input_, cloud_);
  subscribe(bus, channel::kOctomapLevel, octomap_input_, octomap_);
  bus.subscribe(channel::kCostMapIndex.name, [this](const BusMessage& message) {
    index_input_.take(message.bytes, [this](const cost_map_index_t& index, const Object&) { take_index(index); });
  });
  bus.subscribe(channel::kMapLevel.name, [this](const BusMessage& message) {
    level_input_.take(message.bytes, [this](const map_level_t& level, const Object&) { take_level(level); });
  });
}

template <class T>
void MapCopy::subscribe(Bus& bus, const Channel& channel, ObjectInput<T>& input, ListedObjects& objects) {
  bus.subscribe(channel.name, [&input, &objects](const BusMessage& message) {
    input.take(message.bytes, [&objects](const T&, const Object& object) { objects.put(object); });
  });
}

void MapCopy::take_index(const cost_map_index_t& index) {
  check_index(index);
  if (index.map_version < cost_map_.version()) return;
  ListedObjects::List list;
  for (const cost_tile_entry_t& tile : index.tiles) list[tile_key({tile.tile_x, tile.tile_y})] = tile.tile_digest;
  index_ = index;
  cost_map_.list(std::move(list), index.map_version);
}

void MapCopy::take_level(const map_level_t& level) {
  const bool is_cloud = level.level_channel == channel::kCloudLevel.name;
  if (!is_same_voxel(level.voxel_m, is_cloud ? detail_.cloud_m : detail_.octomap_m)) return;
  ListedObjects::List list;
  for (std::size_t i = 0; i < level.tile_key.size(); ++i) list[level.tile_key[i]] = level.tile_digest[i];
  (is_cloud ? cloud_ : octomap_).list(std::move(list), level.map_version);
}

bool MapCopy::is_whole() const {
  return cost_map_.is_whole() && (detail_.cloud_m <= 0.0 || cloud_.is_whole()) &&
         (detail_.octomap_m <= 0.0 || octomap_.is_whole());
}

std::string MapCopy::state() const {
  std::string state = sentence("cost map", cost_map_, "tiles");
  if (detail_.cloud_m > 0.0) state += "; " + sentence(fmt::format("cloud at {} m", detail_.cloud_m), cloud_, "cubes");
  if (detail_.octomap_m > 0.0) {
    state += "; " + sentence(fmt::format("OctoMap at {} m", detail_.octomap_m), octomap_, "cubes");
  }
  return state;
}

CostMap MapCopy::cost_map() const {
  CostMap map{index_.resolution_m, index_.map_origin_m[0], index_.map_origin_m[1], {}};
  for (const auto* bytes : cost_map_.objects()) {
    const auto tile = decode<cost_tile_t>(*bytes);
    map.tiles[{tile.tile_x, tile.tile_y}] = to_cost_tile(tile);
  }
  return map;
}

PointCloud MapCopy::cloud() const {
  PointCloud cloud;
  for (const auto* bytes : cloud_.objects()) {
    const auto tile = decode<cloud_tile_t>(*bytes);
    for (std::size_t i = 0; i < tile.x.size(); ++i) cloud.points.emplace_back(tile.x[i], tile.y[i], tile.z[i]);
    cloud.intensity.insert(cloud.intensity.end(), tile.intensity.begin(), tile.intensity.end());
  }
  if (cloud.intensity.size() != cloud.size()) cloud.intensity.clear();
  return cloud;
}

std::string MapCopy::octomap() const {
  std::optional<OctreeFile> whole;
  for (const auto* bytes : octomap_.objects()) {
    const auto message = decode<octomap_t>(*bytes);
    const std::string stream(message.bt_stream.begin(), message.bt_stream.end());
    const OctreeFile cube(stream, "OCTOMAP_LEVEL");
    whole ? whole->join(cube) : (void)whole.emplace(cube);
  }
  return whole ? whole->bt_bytes() : "";
}

}  // namespace scanway::tools
