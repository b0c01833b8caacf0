#include "modules/mapper/core/registration/voxel_grid.h"

#include <algorithm>

#include "modules/mapper/core/registration/cell_table.h"

namespace scanway::registration {
namespace {

struct Voxel {
  CellKey key = 0;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  std::uint32_t count = 0;
};

bool within_limit(const Eigen::Vector3f& scaled) {
  return scaled.array().abs().maxCoeff() < static_cast<float>(kCellLimit - 1);
}

CellKey key_of(const Eigen::Vector3f& scaled) {
  return cell_key(floor_to_int(scaled.x()), floor_to_int(scaled.y()), floor_to_int(scaled.z()));
}

}  // namespace

Points voxel_centroids(const Points& points, float voxel_m) {
  const float per_metre = 1.0f / voxel_m;
  std::vector<Voxel> voxels;
  CellTable table(points.size() / 8);
  std::uint32_t current = CellTable::kNone;
  for (const Eigen::Vector3f& point : points) {
    const Eigen::Vector3f scaled = point * per_metre;
    if (!within_limit(scaled)) continue;
    const CellKey key = key_of(scaled);
    // Beams come in order, so most points fall into the voxel of the one before: no look-up for them.
    if (current == CellTable::kNone || voxels[current].key != key) {
      const auto fresh = static_cast<std::uint32_t>(voxels.size());
      current = table.find_or_insert(key, fresh);
      if (current == fresh) voxels.push_back({key, Eigen::Vector3d::Zero(), 0});
    }
    voxels[current].sum += point.cast<double>();
    ++voxels[current].count;
  }
  std::sort(voxels.begin(), voxels.end(), [](const Voxel& a, const Voxel& b) { return a.key < b.key; });
  Points centroids(voxels.size());
  std::transform(voxels.begin(), voxels.end(), centroids.begin(),
                 [](const Voxel& v) { return Eigen::Vector3f((v.sum / v.count).cast<float>()); });
  return centroids;
}

}  // namespace scanway::registration
