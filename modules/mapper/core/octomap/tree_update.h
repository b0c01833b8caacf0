#pragma once

#include <octomap/OcTree.h>

#include "modules/mapper/core/octomap/voxel_bricks.h"

namespace scanway {

/// An OcTree that takes all voxels of a sweep at once.
class SweptOcTree : public octomap::OcTree {
 public:
  using octomap::OcTree::OcTree;

  /// Leaves the tree as updateNode(key, occupied, lazy_eval = false) of every voxel does: a voxel that is occupied gets
  /// one hit, one that is free alone gets one miss. Such a tree is always pruned as far as it can be, so it is the same
  /// in whatever order the voxels come, and a cube that is all free is one leaf at once.
  void update(VoxelBricks& bricks);
};

}  // namespace scanway
