#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "modules/mapper/core/cloud/plane_fit.h"
#include "modules/mapper/core/cloud/voxel_sums.h"

namespace scanway {

/// Gives voxels of one sweep the normal of the surface that they lie in, towards the sensor at `origin`: that of the
/// plane through the largest cube about them (128 down to 8 voxels a side) in which all lie in one plane, to within a
/// few voxels. Voxels without such a cube stay without a normal.
class SurfaceNormals {
 public:
  SurfaceNormals(const Eigen::Vector3d& origin, double voxel_m) : origin_(origin / voxel_m) {}

  using Voxels = std::span<VoxelSum>;
  void set(Voxels cube);  ///< All of one cube of 128 voxels a side, by key.

 private:
  using Places = std::span<const Eigen::Vector3d>;  // Of voxels, in voxels from the corner of their largest cube.

  void set(Voxels voxels, Places places, int level) const;
  void split(Voxels voxels, Places places, int level) const;
  void give(const PlaneFit& plane, Voxels voxels) const;

  Eigen::Vector3d origin_, towards_;
  std::vector<Eigen::Vector3d> places_;
};

}  // namespace scanway
