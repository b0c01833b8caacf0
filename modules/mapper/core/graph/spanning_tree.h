#pragma once

#include <cstddef>
#include <vector>

#include "modules/mapper/core/graph/pose_graph.h"

namespace scanway {

/// A tree over the nodes of a graph, as indices of its edges, from the first node (of each part that hangs together,
/// from its lowest).
class SpanningTree {
 public:
  /// The most probable edges (Kruskal's method; of equals the older one).
  explicit SpanningTree(const PoseGraph& graph);

  /// Poses composed along the tree.
  std::vector<Pose> compose() const;
  /// The tree's edges between the ends of `edge`, which is not in it: with it, they form a cycle.
  std::vector<std::size_t> path(std::size_t edge) const;
  bool holds(std::size_t edge) const { return in_tree_[edge]; }
  /// The tree with `inside` replaced by `outside`, on whose path it is.
  SpanningTree exchange(std::size_t inside, std::size_t outside) const;

 private:
  void root();

  const PoseGraph* graph_;
  std::vector<bool> in_tree_;
  std::vector<std::size_t> order_;        ///< Nodes, parents first.
  std::vector<std::size_t> parent_edge_;  ///< Of each node; kNone: it is a root.
  std::vector<std::size_t> depth_;
};

}  // namespace scanway
