#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "common/cloud/point_cloud.h"
#include "modules/mapper/core/cloud/map_points.h"

namespace scanway {

/// The registered cloud: one point a voxel, the centroid of all points that fell into it.
///
/// Coordinates are counted in 1024ths of a voxel and summed in integers, so the cloud is the same whatever the order in
/// which points or sweeps arrive. A centroid is off by at most 1/2048 of a voxel (5 um at 1 cm) a coordinate.
/// Any extent to +-2^20 voxels from the map's origin (10 km at 1 cm); points beyond are left out and counted.
class VoxelCloud {
 public:
  explicit VoxelCloud(double voxel_m);

  /// Adds the points (in the map frame; not finite ones are left out).
  void add(const MapPoints& points);
  /// Takes points away that were added before, the same to the bit: the cloud is then the one that never had them.
  void remove(const MapPoints& points);

  /// Centroids in Morton order of their voxels, in the map frame, with the mean intensity (when points had any).
  PointCloud centroids() const;

  double voxel_m() const { return voxel_m_; }
  std::size_t size() const { return voxels_.size(); }
  std::uint64_t points_out_of_extent() const { return points_out_of_extent_; }

 private:
  /// A voxel's sums. Offsets are from its lowest corner, in 1024ths of a voxel; intensity is in 256ths.
  struct Voxel {
    std::uint64_t key = 0;  ///< Morton code of the voxel's index.
    std::uint32_t count = 0;
    std::uint32_t with_intensity = 0;
    std::array<std::uint64_t, 3> offset_sum{};
    std::int64_t intensity_sum = 0;
  };

  std::vector<Voxel> voxels_of(const MapPoints& points) const;

  double voxel_m_;
  std::vector<Voxel> voxels_;  ///< By key.
  std::uint64_t points_out_of_extent_ = 0;
};

}  // namespace scanway
