#include "modules/mapper/core/registration/voxel_grid.h"

#include <utility>

#include "modules/mapper/core/registration/cell_order.h"

namespace scanway::registration {

void VoxelGrid::enter(CellKey key) {
  const auto fresh = static_cast<std::uint32_t>(voxels_.size());
  current_ = voxel_of_.find_or_insert(key, fresh);
  if (current_ == fresh) voxels_.push_back({key, Eigen::Vector3d::Zero(), 0});
}

Points VoxelGrid::take_centroids() {
  voxel_of_ = CellTable();
  current_ = CellTable::kNone;
  const std::vector<Voxel> voxels = std::exchange(voxels_, {});
  std::vector<KeyedIndex> order;
  order.reserve(voxels.size());
  for (const Voxel& voxel : voxels) order.push_back({voxel.key, static_cast<std::uint32_t>(order.size())});
  sort_by_cell(order);
  Points centroids(voxels.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const Voxel& voxel = voxels[order[i].index];
    centroids[i] = (voxel.sum / voxel.count).cast<float>();
  }
  return centroids;
}

Points voxel_centroids(const Points& points, float voxel_m) {
  VoxelGrid grid(voxel_m, points.size());
  for (const Eigen::Vector3f& point : points) grid.add(point);
  return grid.take_centroids();
}

}  // namespace scanway::registration
