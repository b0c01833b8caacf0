#pragma once

#include <array>
#include <cstdint>

#include "modules/mapper/core/octomap/node_blocks.h"

namespace scanway {

/// The eight children of a node that are voxels, which have no children: their values in log-odds.
struct alignas(32) VoxelBlock {
  std::array<float, 8> log_odds;

  bool has(std::size_t child) const { return !std::isnan(log_odds[child]); }
};

/// The same in half of the bytes, if there are not more than three different values: in nine of ten blocks of a map.
struct alignas(16) FewVoxelValues {
  std::array<float, 3> log_odds;
  std::array<std::uint8_t, 3> places;  ///< Of each value, a bit for each child that has it.
};

/// The voxels of a tree, each block as small as it can be.
struct VoxelBlocks {
  BlockPool<FewVoxelValues> few;
  BlockPool<VoxelBlock> many;

  VoxelBlock operator[](BlockNumber number) const;
};

/// One thread's supply of them.
class VoxelSupply {
 public:
  explicit VoxelSupply(VoxelBlocks& blocks) : blocks_(blocks), few_(blocks.few), many_(blocks.many) {}

  /// Puts values where those of block `number` were, or into a new block if that is 0. Returns the block's number then.
  BlockNumber put(BlockNumber number, const VoxelBlock& values);
  void give_back(BlockNumber number);

 private:
  VoxelBlocks& blocks_;
  BlockSupply<FewVoxelValues> few_;
  BlockSupply<VoxelBlock> many_;
};

}  // namespace scanway
