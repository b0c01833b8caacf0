#include "modules/mapper/core/sweep_graph.h"

#include <algorithm>
#include <utility>

#include "modules/mapper/core/graph/seams.h"

namespace scanway {
namespace {

/// What a registration's covariance, which knows the residuals alone, leaves out: the laser's own bias, the scene's
/// difference between two stands.
constexpr double kLeastTurn = 0.0005, kLeastShift = 0.004;  // radians, metres

Matrix6 covariance_of(const RegistrationResult& registration) {
  Matrix6 covariance = registration.covariance;
  covariance.diagonal().head<3>().array() += kLeastTurn * kLeastTurn;
  covariance.diagonal().tail<3>().array() += kLeastShift * kLeastShift;
  return covariance;
}

std::vector<std::size_t> newly_dropped(const GraphSolution& before, const GraphSolution& after) {
  std::vector<std::size_t> edges;
  for (std::size_t e = 0; e < before.dropped.size(); ++e) {
    if (after.dropped[e] && !before.dropped[e]) edges.push_back(e);
  }
  return edges;
}

}  // namespace

PoseGraph::Node SweepGraph::node_of(const PlacedSweep& sweep) const {
  return {sweep.X_map_sweep * Eigen::Translation3d(sweep.origin), up_of(sweep)};
}

GraphEdge SweepGraph::edge_of(const PlacedSweep& sweep, std::size_t node, const Link& link) const {
  const PlacedSweep& target = sweeps_[link.target];
  const Pose T =
      Eigen::Translation3d(-target.origin) * link.registration.T_target_source * Eigen::Translation3d(sweep.origin);
  return {link.target, node, T, covariance_of(link.registration), link.registration.probability};
}

void SweepGraph::begin(PlacedSweep sweep) {
  graph_.nodes.push_back(node_of(sweep));
  solution_.poses.push_back(graph_.nodes.back().X_map_sensor);
  if (!sweeps_.empty()) {
    graph_.edges.push_back(seam_between(0, sweeps_.size(), graph_));
    solution_.chi_squared.push_back(0.0);
    solution_.dropped.push_back(false);
  }
  sweeps_.push_back(std::move(sweep));
}

bool SweepGraph::add(PlacedSweep sweep, const std::vector<Link>& links) {
  PoseGraph graph = graph_;
  GraphSolution before = solution_;
  const std::size_t node = sweeps_.size();
  graph.nodes.push_back(node_of(sweep));
  for (const Link& link : links) graph.edges.push_back(edge_of(sweep, node, link));
  release_seams(graph, before);
  GraphSolution solution = solve(graph);
  const auto ours = solution.dropped.end() - static_cast<std::ptrdiff_t>(links.size());
  if (std::all_of(ours, solution.dropped.end(), [](bool dropped) { return dropped; })) return false;

  exposed_ = newly_dropped(before, solution);
  graph_ = std::move(graph);
  solution_ = std::move(solution);
  sweeps_.push_back(std::move(sweep));
  for (std::size_t i = 0; i < sweeps_.size(); ++i) {
    sweeps_[i].X_map_sweep = solution_.poses[i] * Eigen::Translation3d(-sweeps_[i].origin);
  }
  return true;
}

void SweepGraph::withdraw(std::size_t sweep) {
  sweeps_[sweep].withdrawn = true;
  take_out(sweep, graph_, solution_);
  exposed_.clear();
}

bool SweepGraph::empty() const {
  return std::all_of(sweeps_.begin(), sweeps_.end(), [](const PlacedSweep& sweep) { return sweep.withdrawn; });
}

}  // namespace scanway
