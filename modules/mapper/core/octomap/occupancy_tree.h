#pragma once

#include <memory>
#include <string>

#include "modules/mapper/core/cloud/map_points.h"

namespace octomap {
class OcTree;
}

namespace scanway {

class SweptOcTree;

struct OccupancyTreeConfig {
  double resolution_m = 0.1;
  double max_range_m = 20.0;  ///< Beams are cut off here; not above 0: they are not cut.
  bool discretize = true;     ///< One ray a voxel that is hit, instead of one a point.
};

/// The OctoMap of the accepted sweeps: what liboctomap's OcTree with its default sensor model holds after
/// insertPointCloud(cloud, origin, max_range, lazy_eval = false, discretize) of each sweep in order.
class OccupancyTree {
 public:
  explicit OccupancyTree(const OccupancyTreeConfig& config);
  ~OccupancyTree();
  OccupancyTree(OccupancyTree&&) noexcept;
  OccupancyTree& operator=(OccupancyTree&&) noexcept;

  /// Points in the map frame; the origin is rounded to float, as OctoMap keeps it.
  void insert(const MapPoints& points);

  std::string ot_bytes() const;  ///< The .ot file: every node's log-odds.
  std::string bt_bytes() const;  ///< The .bt file: each node at its most likely state.
  const octomap::OcTree& tree() const;

 private:
  OccupancyTreeConfig config_;
  std::unique_ptr<SweptOcTree> tree_;
};

}  // namespace scanway
