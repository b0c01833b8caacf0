#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "modules/mapper/core/octomap/node_blocks.h"
#include "modules/mapper/core/octomap/tree_blocks.h"
#include "modules/mapper/core/octomap/voxel_bricks.h"

namespace scanway {

/// octomap::OcTree's default sensor model, rounded to float as there.
struct SensorModel {
  SensorModel();
  float hit, miss, least, most;

  float after(float before, float change) const { return std::min(std::max(before + change, least), most); }
};

/// A node by its place: in the block of its parent's children.
struct Node {
  NodeBlock* block;
  std::size_t child;
  bool is_new;  ///< Not yet of any value.

  float& log_odds() const { return block->log_odds[child]; }
  BlockNumber& children() const { return block->children[child]; }
  bool is_leaf() const { return children() == 0; }
};

/// One thread's part in an update of a tree's nodes.
class NodeUpdate {
 public:
  explicit NodeUpdate(TreeBlocks& blocks)
      : nodes_(blocks.nodes), voxels_(blocks.voxels), node_supply_(blocks.nodes), voxel_supply_(blocks.voxels) {}

  /// What a sweep says of the node's brick, in which no voxel is both free and occupied. The node is then not new.
  void update(Node& node, const VoxelBrick& brick);

  /// Makes room for a leaf's children, which are no voxels: of a new node there are none yet, of any other all, like
  /// it.
  void open(const Node& node) {
    node.children() = node_supply_.take();
    nodes_[node.children()].fill(value_of_children(node));
  }
  /// A child of a node that has been opened.
  Node child_of(const Node& node, std::size_t i);
  /// The place of a child that may not be there.
  Node place_of(const Node& node, std::size_t i) { return {&nodes_[node.children()], i, false}; }
  /// Prunes, or takes the most occupied child's value; without children the node is removed.
  void finish_or_remove(const Node& node);
  /// Forgets all that is below a node of that level, and the node.
  void remove(const Node& node, int level);

 private:
  /// What a sweep says of a cube: its voxels' bits.
  struct Cube {
    std::span<const std::uint64_t> free, occupied;

    bool untouched() const;
    Cube child(std::size_t i) const {
      const std::size_t words = free.size() / 8;
      return {free.subspan(i * words, words), occupied.subspan(i * words, words)};
    }
  };
  /// A cube of 64 voxels or fewer, in the lowest bits.
  struct SmallCube {
    std::uint64_t free, occupied;
  };

  void update_cube(const Node& node, const Cube& cube);
  void update_word(const Node& node, const SmallCube& cube);
  void update_byte(const Node& node, const SmallCube& cube);
  VoxelBlock voxels_of(const Node& node) const;
  void finish(const Node& node);
  void finish(const Node& node, const VoxelBlock& voxels);

  static float value_of_children(const Node& node) { return node.is_new ? kNoNode : node.log_odds(); }
  /// Whether a leaf's value can go no further, so that it does not matter which of its voxels are touched.
  bool at_bound(const Node& node, float bound) const { return !node.is_new && node.log_odds() == bound; }
  void add(const Node& node, float change) const { node.log_odds() = model_.after(node.log_odds(), change); }

  BlockPool<NodeBlock>& nodes_;
  VoxelBlocks& voxels_;
  BlockSupply<NodeBlock> node_supply_;
  VoxelSupply voxel_supply_;
  SensorModel model_;
};

}  // namespace scanway
