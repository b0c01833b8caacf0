#include "modules/mapper/core/registration/voxel_grid.h"

#include <algorithm>
#include <utility>

namespace scanway::registration {

void VoxelGrid::enter(CellKey key) {
  const auto fresh = static_cast<std::uint32_t>(voxels_.size());
  current_ = voxel_of_.find_or_insert(key, fresh);
  if (current_ == fresh) voxels_.push_back({key, Eigen::Vector3d::Zero(), 0});
}

Points VoxelGrid::take_centroids() {
  voxel_of_ = CellTable();
  current_ = CellTable::kNone;
  std::vector<Voxel> voxels = std::exchange(voxels_, {});
  std::sort(voxels.begin(), voxels.end(), [](const Voxel& a, const Voxel& b) { return a.key < b.key; });
  Points centroids(voxels.size());
  std::transform(voxels.begin(), voxels.end(), centroids.begin(),
                 [](const Voxel& v) { return Eigen::Vector3f((v.sum / v.count).cast<float>()); });
  return centroids;
}

Points voxel_centroids(const Points& points, float voxel_m) {
  VoxelGrid grid(voxel_m, points.size());
  for (const Eigen::Vector3f& point : points) grid.add(point);
  return grid.take_centroids();
}

}  // namespace scanway::registration
