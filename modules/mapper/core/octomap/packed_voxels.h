#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include "modules/mapper/core/octomap/voxel_bricks.h"

namespace scanway {

/// A brick in which no voxel is both free and occupied (occupied wins), without other loss: words of which all bits are
/// set, or none, take no place.
class PackedBrick {
 public:
  explicit PackedBrick(VoxelBrick brick);
  VoxelBrick unpacked() const;

 private:
  struct Half {
    std::uint64_t full = 0, mixed = 0;  ///< A bit a word.
  };
  Half pack(const std::array<std::uint64_t, kBrickWords>& words);

  Half free_, occupied_;
  std::vector<std::uint64_t> mixed_words_;  ///< Free ones first.
};

/// What every sweep says of the voxels, by brick and, in a brick, oldest sweep first.
class VoxelHistory {
 public:
  using SweepNumber = std::uint64_t;
  using BrickHistory = std::map<SweepNumber, PackedBrick>;

  void put(SweepNumber sweep, VoxelBricks& bricks);
  /// The bricks that the sweep touched, in order.
  std::vector<VoxelBricks::BrickNumber> forget(SweepNumber sweep);
  /// What sweeps say of a brick; empty when there is none.
  const BrickHistory& of(VoxelBricks::BrickNumber number) const;

 private:
  std::map<VoxelBricks::BrickNumber, BrickHistory> bricks_;
};

}  // namespace scanway
