#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "common/bus/bus.h"
#include "common/cloud/point_cloud.h"
#include "common/grid/cost_map.h"
#include "common/messages/object_input.h"
#include "modules/tools/map/listed_objects.h"
#include "scanway/cloud_tile_t.hpp"
#include "scanway/cost_map_index_t.hpp"
#include "scanway/cost_tile_t.hpp"
#include "scanway/map_level_t.hpp"
#include "scanway/octomap_t.hpp"

namespace scanway::tools {

/// The detail in which somebody wants a map.
struct MapDetail {
  double cloud_m = 0.1;    ///< 0: no cloud.
  double octomap_m = 0.0;  ///< 0: no OctoMap.
};

/// The map of another machine as it arrives: the whole cost map, cloud and OctoMap in the detail that was asked for.
/// Knows at any time what it lacks.
class MapCopy {
 public:
  /// `bus` must outlive this.
  MapCopy(Bus& bus, const MapDetail& detail);

  bool is_whole() const;
  /// What is here and what lacks, for people.
  std::string state() const;

  std::int64_t cost_map_digest() const { return index_.map_digest; }
  /// Of what is here.
  CostMap cost_map() const;
  PointCloud cloud() const;
  /// The .bt file; empty: none was asked for, or nothing of it is here.
  std::string octomap() const;

 private:
  void take_index(const cost_map_index_t& index);
  void take_level(const map_level_t& level);
  template <class T>
  void subscribe(Bus& bus, const Channel& channel, ObjectInput<T>& input, ListedObjects& objects);

  MapDetail detail_;
  ObjectInput<cost_tile_t> tile_input_;
  ObjectInput<cost_map_index_t> index_input_;
  ObjectInput<cloud_tile_t> cloud_input_;
  ObjectInput<octomap_t> octomap_input_;
  ObjectInput<map_level_t> level_input_;
  cost_map_index_t index_{};
  ListedObjects cost_map_, cloud_, octomap_;
};

}  // namespace scanway::tools
