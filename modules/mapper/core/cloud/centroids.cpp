#include "modules/mapper/core/cloud/centroids.h"

#include <cmath>

#include "modules/mapper/core/cloud/voxel_place.h"

namespace scanway {
namespace {

Eigen::Vector3f direction_of(const std::array<std::int32_t, 3>& normal_sum) {
  const Eigen::Vector3d sum(normal_sum[0], normal_sum[1], normal_sum[2]);
  const double length = sum.norm();
  return length > 0.0 ? Eigen::Vector3f((sum / length).cast<float>()) : Eigen::Vector3f::Zero();
}

float mean_intensity(const VoxelSum& voxel) {
  const double sum = static_cast<double>(voxel.intensity_sum) / kIntensityUnit;
  return voxel.with_intensity == 0 ? 0.0f : static_cast<float>(sum / voxel.with_intensity);
}

}  // namespace

Centroids::Centroids(double voxel_m, bool with_intensity, PointCloud& cloud)
    : unit_(voxel_m / static_cast<double>(kFractions)), with_intensity_(with_intensity), cloud_(cloud) {}

void Centroids::append(std::span<const VoxelSum> cube) {
  if (cube.empty()) return;
  const PlacesInCube& in_cube = PlacesInCube::table();
  const Eigen::Vector3d corner = corner_of_cube(cube_of(cube.front().key));
  for (const VoxelSum& voxel : cube) {
    const Eigen::Vector3d index = corner + in_cube.corner(voxel.key);
    Eigen::Vector3f point;
    for (int k = 0; k < 3; ++k) {
      const double mean = static_cast<double>(voxel.offset_sum[static_cast<std::size_t>(k)]) / voxel.count;
      point[k] = static_cast<float>((index[k] * static_cast<double>(kFractions) + mean) * unit_);
    }
    cloud_.points.push_back(point);
    cloud_.normals.push_back(mean_normal(voxel));
    if (with_intensity_) cloud_.intensity.push_back(mean_intensity(voxel));
  }
}

const Eigen::Vector3f& Centroids::mean_normal(const VoxelSum& voxel) {
  Known& known = known_[voxel.count % known_.size()];
  if (known.sum != voxel.normal_sum) known = {voxel.normal_sum, direction_of(voxel.normal_sum)};
  return known.direction;
}

}  // namespace scanway
