#pragma once

#include <array>
#include <cstdint>
#include <span>

#include <Eigen/Core>

#include "common/cloud/point_cloud.h"
#include "modules/mapper/core/cloud/voxel_sums.h"

namespace scanway {

/// Appends to a cloud each voxel's centroid, the direction of all its points' normals together (0 where none is known,
/// or they are against each other), and if asked for its mean intensity (0 where no point had any).
class Centroids {
 public:
  Centroids(double voxel_m, bool with_intensity, PointCloud& cloud);

  void append(std::span<const VoxelSum> cube);  ///< Voxels of one cube of 128 a side.

 private:
  const Eigen::Vector3f& mean_normal(const VoxelSum& voxel);

  /// Voxels on one plane have the same few sums, by their number of points.
  struct Known {
    std::array<std::int32_t, 3> sum{};
    Eigen::Vector3f direction = Eigen::Vector3f::Zero();
  };

  double unit_;
  bool with_intensity_;
  PointCloud& cloud_;
  std::array<Known, 8> known_;
};

}  // namespace scanway
