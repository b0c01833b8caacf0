#pragma once

#include <string>
#include <vector>

#include "common/robot/robot.h"
#include "modules/mapper/core/graph/pose_graph.h"
#include "modules/mapper/core/locate.h"

namespace scanway {

/// The sweeps of the map and what holds them together.
class SweepGraph {
 public:
  explicit SweepGraph(const Robot& robot) { graph_.tilt_sigma = robot.tracker.tilt_sigma; }

  /// The first, at its pose; or the first after all others were withdrawn.
  void begin(PlacedSweep sweep);
  /// Adds a sweep and its links, and settles all poses anew. False: all of its links contradict what is more likely;
  /// nothing changed.
  bool add(PlacedSweep sweep, const std::vector<Link>& links);
  /// From now on it holds and tells nothing (seams.h). All poses stay as they are until the next sweep is added.
  void withdraw(std::size_t sweep);

  /// Whether there is a sweep to register another to.
  bool empty() const;
  const std::vector<PlacedSweep>& sweeps() const { return sweeps_; }
  const PoseGraph& graph() const { return graph_; }
  const GraphSolution& solution() const { return solution_; }
  /// Edges between earlier sweeps that the newest one showed to be wrong.
  const std::vector<std::size_t>& exposed() const { return exposed_; }

 private:
  PoseGraph::Node node_of(const PlacedSweep& sweep) const;
  GraphEdge edge_of(const PlacedSweep& sweep, std::size_t node, const Link& link) const;

  std::vector<PlacedSweep> sweeps_;
  PoseGraph graph_;
  GraphSolution solution_;
  std::vector<std::size_t> exposed_;
};

}  // namespace scanway
