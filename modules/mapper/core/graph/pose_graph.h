#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "common/geometry/pose.h"

namespace scanway {

using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

/// Two sweeps that were registered: nodes of the graph, `to` in the frame of `from`.
struct GraphEdge {
  std::size_t from = 0, to = 0;
  Pose T_from_to = Pose::Identity();
  /// Of [rotation vector w, translation v] in the axes of `from`, `to` turned about its own origin: exp(w) R, t + v.
  Matrix6 covariance = Matrix6::Identity();
  double probability = 0.0;  ///< That the edge is right.
  bool seam = false;         ///< No registration: see seams.h.
};

/// Poses of sweeps' sensors and what is known of them. The first node's pose is the frame of all.
struct PoseGraph {
  struct Node {
    Pose X_map_sensor = Pose::Identity();  ///< Of the first: fixed. Of others only for those that no edge holds.
    std::optional<Eigen::Vector3d> up;     ///< In the node's frame, by its tracker.
  };
  std::vector<Node> nodes;
  std::vector<GraphEdge> edges;
  double tilt_sigma = 0.0087;  ///< Of `up`, radians a direction.
};

/// How the graph's edges agree.
struct GraphSolution {
  std::vector<Pose> poses;          ///< X_map_sensor, one a node.
  std::vector<double> chi_squared;  ///< Of each edge at these poses, with 6 degrees of freedom.
  std::vector<bool> dropped;        ///< Of each edge: it contradicts the others, and they are more likely right.
  double cost = 0.0;                ///< Twice the negative log-likelihood of all, wrong edges included.
};

/// The most likely poses where each edge is right with its probability: an edge is dropped where that costs less than
/// bending the others to it.
///
/// A right edge has a chi-squared of 6 degrees of freedom; it is dropped beyond c^2 = 22.5 (one right edge in a
/// thousand) + 2 log(p / (1 - p)): the outlier process of Black and Rangarajan (IJCV 19(1), 1996), as switchable
/// constraints and DCS have it. Poses are composed over the tree of the most probable edges and refined by Gauss-Newton
/// with the Geman-McClure kernel, at first as wide as the cycle is long that an edge closes. Then the tree is doubted:
/// wherever an edge was dropped, each edge of its cycle is left out in its place, and the cheapest solution wins; of
/// equals, the one that keeps older edges.
GraphSolution solve(const PoseGraph& graph);

}  // namespace scanway
