#pragma once

#include <cstdint>
#include <vector>

#include "modules/mapper/core/cloud/packed_sums.h"
#include "modules/mapper/core/cloud/voxel_sums.h"

namespace scanway {

/// What all sweeps say of one tile's voxels, a cube of 128 a side after the other.
class TileSums {
 public:
  /// What one sweep says, packed from `first_key` on.
  void add(std::vector<std::uint8_t> bytes, std::uint64_t first_key, bool with_intensity);

  /// False after the last cube.
  bool next();
  /// The cube's voxels, by key, added up.
  const std::vector<VoxelSum>& cube() const { return cube_; }

 private:
  std::vector<std::vector<std::uint8_t>> bytes_;
  std::vector<SumReader> readers_;
  std::vector<VoxelSum> cube_;
};

}  // namespace scanway
