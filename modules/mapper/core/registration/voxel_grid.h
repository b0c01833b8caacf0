#pragma once

#include <vector>

#include "modules/mapper/core/registration/cell_table.h"
#include "modules/mapper/core/registration/points.h"

namespace scanway::registration {

/// The centroids of the points of every occupied voxel of edge `voxel_m`. Voxel (i, j, k) holds
/// i <= x / voxel_m < i + 1. Exact as long as every coordinate lies within 2^20 voxels of the origin; points beyond are
/// left out. Takes points one by one, so that nobody has to hold a copy of a scan.
class VoxelGrid {
 public:
  VoxelGrid(float voxel_m, std::size_t expected_points) : per_metre_(1.0f / voxel_m), voxel_of_(expected_points / 8) {}

  void add(const Eigen::Vector3f& point) {
    const Eigen::Vector3f scaled = point * per_metre_;
    if (!(scaled.array().abs().maxCoeff() < static_cast<float>(kCellLimit - 1))) return;
    const CellKey key = cell_key(floor_to_int(scaled.x()), floor_to_int(scaled.y()), floor_to_int(scaled.z()));
    // Beams come in order, so most points fall into the voxel of the one before: no look-up for them.
    if (current_ == CellTable::kNone || voxels_[current_].key != key) enter(key);
    voxels_[current_].sum += point.cast<double>();
    ++voxels_[current_].count;
  }

  /// In the order of the voxels (z, y, x), so that neighbours in space are mostly neighbours in memory. The grid is
  /// empty then.
  Points take_centroids();

 private:
  struct Voxel {
    CellKey key = 0;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    std::uint32_t count = 0;
  };

  void enter(CellKey key);

  float per_metre_;
  std::vector<Voxel> voxels_;
  CellTable voxel_of_;
  std::uint32_t current_ = CellTable::kNone;
};

Points voxel_centroids(const Points& points, float voxel_m);

}  // namespace scanway::registration
