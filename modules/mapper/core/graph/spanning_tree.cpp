#include "modules/mapper/core/graph/spanning_tree.h"

#include <algorithm>
#include <numeric>

#include "modules/mapper/core/graph/parts.h"

namespace scanway {
namespace {

constexpr std::size_t kNone = static_cast<std::size_t>(-1);

std::size_t other_end(const GraphEdge& edge, std::size_t node) { return edge.from == node ? edge.to : edge.from; }

}  // namespace

SpanningTree::SpanningTree(const PoseGraph& graph) : graph_(&graph), in_tree_(graph.edges.size(), false) {
  std::vector<std::size_t> by_probability(graph.edges.size());
  std::iota(by_probability.begin(), by_probability.end(), std::size_t{0});
  std::stable_sort(by_probability.begin(), by_probability.end(), [&](std::size_t a, std::size_t b) {
    return graph.edges[a].probability > graph.edges[b].probability;
  });
  Parts parts(graph.nodes.size());
  for (const std::size_t edge : by_probability) {
    in_tree_[edge] = parts.join(graph.edges[edge].from, graph.edges[edge].to);
  }
  root();
}

void SpanningTree::root() {
  const std::size_t count = graph_->nodes.size();
  std::vector<std::vector<std::size_t>> edges_at(count);
  for (std::size_t edge = 0; edge < graph_->edges.size(); ++edge) {
    if (!in_tree_[edge]) continue;
    edges_at[graph_->edges[edge].from].push_back(edge);
    edges_at[graph_->edges[edge].to].push_back(edge);
  }
  order_.clear();
  parent_edge_.assign(count, kNone);
  depth_.assign(count, kNone);
  for (std::size_t root = 0; root < count; ++root) {
    if (depth_[root] != kNone) continue;
    depth_[root] = 0;
    order_.push_back(root);
    for (std::size_t next = order_.size() - 1; next < order_.size(); ++next) {
      const std::size_t node = order_[next];
      for (const std::size_t edge : edges_at[node]) {
        const std::size_t child = other_end(graph_->edges[edge], node);
        if (depth_[child] != kNone) continue;
        depth_[child] = depth_[node] + 1;
        parent_edge_[child] = edge;
        order_.push_back(child);
      }
    }
  }
}

std::vector<Pose> SpanningTree::compose() const {
  std::vector<Pose> poses(graph_->nodes.size());
  for (const std::size_t node : order_) {
    if (parent_edge_[node] == kNone) {
      poses[node] = graph_->nodes[node].X_map_sensor;
      continue;
    }
    const GraphEdge& edge = graph_->edges[parent_edge_[node]];
    poses[node] = edge.to == node ? poses[edge.from] * edge.T_from_to : poses[edge.to] * edge.T_from_to.inverse();
  }
  return poses;
}

std::vector<std::size_t> SpanningTree::path(std::size_t edge) const {
  std::size_t a = graph_->edges[edge].from, b = graph_->edges[edge].to;
  std::vector<std::size_t> path;
  while (a != b) {
    std::size_t& deeper = depth_[a] >= depth_[b] ? a : b;
    path.push_back(parent_edge_[deeper]);
    deeper = other_end(graph_->edges[path.back()], deeper);
  }
  return path;
}

SpanningTree SpanningTree::exchange(std::size_t inside, std::size_t outside) const {
  SpanningTree changed = *this;
  changed.in_tree_[inside] = false;
  changed.in_tree_[outside] = true;
  changed.root();
  return changed;
}

}  // namespace scanway
