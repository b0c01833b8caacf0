#pragma once

#include "modules/mapper/core/octomap/node_blocks.h"
#include "modules/mapper/core/octomap/voxel_blocks.h"

namespace scanway {

/// All blocks of a tree.
struct TreeBlocks {
  BlockPool<NodeBlock> nodes;
  VoxelBlocks voxels;
};

}  // namespace scanway
