#pragma once

#include <string>
#include <vector>

#include "modules/mapper/core/octomap/occupancy_tree.h"

namespace scanway {

/// The two files of a tree.
struct TreeFiles {
  std::string ot, bt;
  bool operator==(const TreeFiles&) const = default;
};

/// What liboctomap's own insertPointCloud makes of the sweeps.
TreeFiles files_of_liboctomap(const std::vector<MapPoints>& sweeps, const OccupancyTreeConfig& config);
TreeFiles files_of_ours(const std::vector<MapPoints>& sweeps, const OccupancyTreeConfig& config);

}  // namespace scanway
