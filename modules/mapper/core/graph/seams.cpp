#include "modules/mapper/core/graph/seams.h"

#include "modules/mapper/core/graph/parts.h"

namespace scanway {
namespace {

/// Whether the ends of an edge hang together without it, by edges that were not dropped.
bool is_spare(std::size_t edge, const PoseGraph& graph, const GraphSolution& solution) {
  Parts parts(graph.nodes.size());
  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    const bool dropped = e < solution.dropped.size() && solution.dropped[e];
    if (e != edge && !dropped) parts.join(graph.edges[e].from, graph.edges[e].to);
  }
  return parts.of(graph.edges[edge].from) == parts.of(graph.edges[edge].to);
}

void erase(std::size_t edge, PoseGraph& graph, GraphSolution& solution) {
  const auto at = static_cast<std::ptrdiff_t>(edge);
  graph.edges.erase(graph.edges.begin() + at);
  solution.chi_squared.erase(solution.chi_squared.begin() + at);
  solution.dropped.erase(solution.dropped.begin() + at);
}

}  // namespace

void take_out(std::size_t node, PoseGraph& graph, GraphSolution& solution) {
  graph.nodes[node].up.reset();
  for (std::size_t e = graph.edges.size(); e-- > 0;) {
    GraphEdge& edge = graph.edges[e];
    if (edge.from != node && edge.to != node) continue;
    if (solution.dropped[e] || is_spare(e, graph, solution)) {
      erase(e, graph, solution);
      continue;
    }
    edge.seam = true;
    edge.T_from_to = solution.poses[edge.from].inverse() * solution.poses[edge.to];
    solution.chi_squared[e] = 0.0;
  }
}

void release_seams(PoseGraph& graph, GraphSolution& solution) {
  for (std::size_t e = solution.dropped.size(); e-- > 0;) {
    if (graph.edges[e].seam && is_spare(e, graph, solution)) erase(e, graph, solution);
  }
}

GraphEdge seam_between(std::size_t from, std::size_t to, const PoseGraph& graph) {
  GraphEdge seam;
  seam.from = from;
  seam.to = to;
  seam.T_from_to = graph.nodes[from].X_map_sensor.inverse() * graph.nodes[to].X_map_sensor;
  seam.probability = 1.0;
  seam.seam = true;
  return seam;
}

}  // namespace scanway
