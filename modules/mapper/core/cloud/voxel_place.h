#pragma once

#include <array>
#include <cstdint>

#include <Eigen/Core>

#include "modules/mapper/core/cloud/voxel_sums.h"

namespace scanway {

constexpr int kFractionBits = 10;  ///< Of offsets in a voxel.
constexpr std::int64_t kFractions = std::int64_t{1} << kFractionBits;
constexpr int kExtentBits = 20;
constexpr std::int64_t kHalfExtent = std::int64_t{1}
                                     << kExtentBits;  ///< Voxels: 21 bits a coordinate make a 63-bit Morton code.

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

constexpr int kCubeLevel = 7;  ///< Voxels are worked on by cubes of 2^7 a side: what one holds stays in the cache.
constexpr int kCubeBits = 3 * kCubeLevel;
constexpr std::uint64_t kVoxelsInCube = std::uint64_t{1} << kCubeBits;

inline std::uint64_t cube_of(std::uint64_t key) { return key >> kCubeBits; }
inline Eigen::Vector3d corner_of_cube(std::uint64_t cube) { return corner_of(cube << kCubeBits); }

/// Where voxels lie in their cube.
class PlacesInCube {
 public:
  /// By the voxel's index in the cube along one axis: its bits, two zeros after each.
  std::uint32_t spread(std::uint32_t index) const { return spread_[index]; }

  /// The lowest corner of the voxel of that key, in voxels from its cube's.
  Eigen::Vector3d corner(std::uint64_t key) const {
    const std::uint64_t place = key % kVoxelsInCube;
    const std::uint32_t indices = gathered_[place % kGathered] | gathered_[place / kGathered] << 4;
    return Eigen::Vector3d(indices & 255, indices >> 8 & 255, indices >> 16);
  }

  /// A voxel's centroid, in voxels from its cube's lowest corner.
  Eigen::Vector3d place(const VoxelSum& voxel) const {
    Eigen::Vector3d place = corner(voxel.key);
    const double unit = 1.0 / (static_cast<double>(kFractions) * voxel.count);
    for (int k = 0; k < 3; ++k) place[k] += static_cast<double>(voxel.offset_sum[static_cast<std::size_t>(k)]) * unit;
    return place;
  }

  static const PlacesInCube& table() {
    static const PlacesInCube places;
    return places;
  }

 private:
  PlacesInCube() {
    for (std::uint32_t i = 0; i < spread_.size(); ++i) spread_[i] = static_cast<std::uint32_t>(spread_bits(i));
    for (std::uint32_t i = 0; i < kGathered; ++i) {
      gathered_[i] = static_cast<std::uint32_t>(gather_bits(i) | gather_bits(i >> 1) << 8 | gather_bits(i >> 2) << 16);
    }
  }

  static constexpr std::size_t kGathered = 1 << 12;
  std::array<std::uint32_t, 1 << kCubeLevel> spread_{};
  std::array<std::uint32_t, kGathered> gathered_{};  ///< A byte an axis.
};

}  // namespace scanway
