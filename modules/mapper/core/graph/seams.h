#pragma once

#include "modules/mapper/core/graph/pose_graph.h"

namespace scanway {

/// Takes a node's say out of a solved graph: its tracker's and that of its edges, which go. Where nothing else joins
/// what they joined, one stays as a seam: it holds the parts, and the node itself, as they lie in `solution`. No cycle
/// runs through a seam, so it bends nothing. `solution` loses the same edges; its poses stay.
void take_out(std::size_t node, PoseGraph& graph, GraphSolution& solution);

/// Once edges that `solution` does not know yet join what a seam holds, it goes, from both: registrations alone say
/// then how the parts lie.
void release_seams(PoseGraph& graph, GraphSolution& solution);

/// That `to` lies to `from` as it does now.
GraphEdge seam_between(std::size_t from, std::size_t to, const PoseGraph& graph);

}  // namespace scanway
