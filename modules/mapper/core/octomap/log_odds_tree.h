#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

#include "modules/mapper/core/octomap/tree_blocks.h"
#include "modules/mapper/core/octomap/voxel_bricks.h"
#include "modules/mapper/core/octomap/voxel_history.h"

namespace scanway {

/// Takes a file's bytes, some after the other.
using TakeBytes = std::function<void(std::string_view)>;

/// octomap::OcTree with its default sensor model, as far as sweeps and files need it, in blocks instead of nodes with
/// an allocation each. Values are added and cut off as OctoMap does it, in float.
class LogOddsTree {
 public:
  LogOddsTree();

  /// Leaves the tree as updateNode(key, occupied, lazy_eval = false) of every voxel does: a voxel that is occupied gets
  /// one hit, one that is free alone gets one miss. Such a tree is always pruned as far as it can be, so it is the same
  /// in whatever order the voxels come, and a cube that is all free is one leaf at once.
  void update(VoxelBricks& bricks);

  /// Makes these bricks anew, as if no other sweep had ever touched them than those that history holds.
  void remake(const BrickNumbers& numbers, const VoxelHistory& history);

  struct Size {
    std::size_t nodes = 0, leaves = 0;
  };
  Size size() const;

  /// The files that OcTree::write and writeBinary make (the latter of a tree whose nodes are set to their most likely
  /// state and pruned; this tree stays as it is).
  void write_ot(double resolution_m, const TakeBytes& take) const;
  std::string bt_bytes(double resolution_m) const;

 private:
  TreeBlocks blocks_;
  NodeBlock top_;  ///< Its first node is the root.
};

}  // namespace scanway
