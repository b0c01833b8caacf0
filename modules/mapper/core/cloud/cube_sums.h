#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "modules/mapper/core/cloud/cube_runs.h"
#include "modules/mapper/core/cloud/fixed_places.h"
#include "modules/mapper/core/cloud/map_points.h"
#include "modules/mapper/core/cloud/voxel_sums.h"

namespace scanway {

/// Adds up the points of one cube after the other.
class CubeSums {
 public:
  CubeSums(const MapPoints& points, double voxel_m) : points_(points), voxel_m_(voxel_m) {}

  /// The voxels of the cube of these runs, by key, without normals; until the next call.
  std::vector<VoxelSum>& add_up(std::span<const CubeRun> runs);

 private:
  /// A point on its way to its voxel.
  struct Entry {
    std::uint32_t voxel;   ///< Its key's part in the cube.
    std::uint32_t offset;  ///< Three times kFractionBits.
    float intensity;
  };

  void take(const CubeRun& run);
  void sort();
  void add_up(std::uint64_t first_key);

  const MapPoints& points_;
  double voxel_m_;
  std::vector<FixedPlace> places_;
  std::vector<Entry> entries_, sorted_;
  std::vector<VoxelSum> voxels_;
};

}  // namespace scanway
