#pragma once

#include <cstdint>

#include <Eigen/Core>

#include "modules/mapper/core/cloud/voxel_sums.h"

namespace scanway {

constexpr int kFractionBits = 10;  ///< Of offsets in a voxel.
constexpr std::int64_t kFractions = std::int64_t{1} << kFractionBits;
constexpr std::int64_t kHalfExtent = std::int64_t{1}
                                     << 20;  ///< Voxels: 21 bits a coordinate make a 63-bit Morton code.

/// The low 21 bits of v, two zeros after each.
constexpr std::uint64_t spread_bits(std::uint64_t v) {
  v &= 0x1FFFFF;
  v = (v | v << 32) & 0x001F00000000FFFF;
  v = (v | v << 16) & 0x001F0000FF0000FF;
  v = (v | v << 8) & 0x100F00F00F00F00F;
  v = (v | v << 4) & 0x10C30C30C30C30C3;
  v = (v | v << 2) & 0x1249249249249249;
  return v;
}

constexpr std::uint64_t gather_bits(std::uint64_t v) {
  v &= 0x1249249249249249;
  v = (v | v >> 2) & 0x10C30C30C30C30C3;
  v = (v | v >> 4) & 0x100F00F00F00F00F;
  v = (v | v >> 8) & 0x001F0000FF0000FF;
  v = (v | v >> 16) & 0x001F00000000FFFF;
  v = (v | v >> 32) & 0x00000000001FFFFF;
  return v;
}

/// The lowest corner of the voxel of that key, in voxels from the map's origin.
inline Eigen::Vector3d corner_of(std::uint64_t key) {
  Eigen::Vector3d corner;
  for (int k = 0; k < 3; ++k) {
    corner[k] = static_cast<double>(static_cast<std::int64_t>(gather_bits(key >> k)) - kHalfExtent);
  }
  return corner;
}

/// A voxel's centroid, in voxels from the map's origin.
inline Eigen::Vector3d place_of(const VoxelSum& voxel) {
  Eigen::Vector3d place = corner_of(voxel.key);
  const double unit = 1.0 / (static_cast<double>(kFractions) * voxel.count);
  for (int k = 0; k < 3; ++k) place[k] += static_cast<double>(voxel.offset_sum[static_cast<std::size_t>(k)]) * unit;
  return place;
}

}  // namespace scanway
