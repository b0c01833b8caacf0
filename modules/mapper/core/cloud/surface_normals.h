#pragma once

#include <vector>

#include <Eigen/Core>

#include "modules/mapper/core/cloud/voxel_sums.h"

namespace scanway {

/// Gives the voxels of one sweep, in order, the normal of the surface that they lie in, towards the sensor at `origin`:
/// that of the plane through the largest cube about them (128 down to 8 voxels a side) in which all lie in one plane,
/// to within a few voxels. Voxels without such a cube stay without a normal.
void set_normals(std::vector<VoxelSum>& voxels, const Eigen::Vector3d& origin, double voxel_m);

}  // namespace scanway
