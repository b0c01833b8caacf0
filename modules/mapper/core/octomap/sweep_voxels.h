#pragma once

#include <vector>

#include <Eigen/Core>

#include "modules/mapper/core/octomap/key_grid.h"
#include "modules/mapper/core/octomap/voxel_bricks.h"

namespace scanway {

struct OccupancyTreeConfig;

/// The voxels that OccupancyOcTreeBase::computeUpdate (discretize: computeDiscreteUpdate) finds occupied and free in
/// one sweep, except that an occupied one may be free as well.
VoxelBricks sweep_voxels(const std::vector<Eigen::Vector3f>& points, const octomap::point3d& origin,
                         const KeyGrid& grid, const OccupancyTreeConfig& config);

}  // namespace scanway
