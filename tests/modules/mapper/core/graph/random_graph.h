#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "common/math/repeatable.h"
#include "common/random/random.h"
#include "modules/mapper/core/graph/pose_graph.h"

namespace scanway::testing {

/// A graph whose true poses are known: a robot that drove a circle.
struct KnownGraph {
  PoseGraph graph;
  std::vector<Pose> truth;
};

inline Vector6 noise(Random& random, double turn, double shift) {
  Vector6 v;
  for (int k = 0; k < 3; ++k) v[k] = turn * random.normal();
  for (int k = 3; k < 6; ++k) v[k] = shift * random.normal();
  return v;
}

/// T, turned about its own origin and shifted, in the axes that T leads to.
inline Pose disturbed(const Pose& T, const Vector6& v) {
  Pose result = T;
  result.linear() = exp_so3(v.head<3>()) * T.linear();
  result.translation() += v.tail<3>();
  return result;
}

inline void add_edge(KnownGraph& known, std::size_t from, std::size_t to, double probability, const Vector6& error,
                     double turn, double shift) {
  GraphEdge edge{from, to, known.truth[from].inverse() * known.truth[to], Matrix6::Zero(), probability};
  edge.T_from_to = disturbed(edge.T_from_to, error);
  edge.covariance.diagonal() << Vector6::Constant(turn * turn).head<3>(), Vector6::Constant(shift * shift).head<3>();
  known.graph.edges.push_back(edge);
}

/// `count` nodes on a circle of `radius`, each linked to `links` before it, and the last ones to the first.
inline KnownGraph circle(std::size_t count, std::size_t links, std::uint64_t seed, double turn, double shift,
                         double radius = 30.0, double tilt = 0.0087) {
  KnownGraph known;
  Random random(seed);
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = 2.0 * repeatable::kPi * static_cast<double>(i) / static_cast<double>(count);
    Pose X = Pose::Identity();
    X.linear() = rotation_about_z(angle) * exp_so3(noise(random, 0.02, 0.0).head<3>());
    X.translation() << radius * repeatable::sin(angle), radius * (1.0 - repeatable::cos(angle)), 0.3 * random.normal();
    known.truth.push_back(X);
    PoseGraph::Node node{
        X, X.linear().transpose() * (exp_so3(noise(random, tilt, 0.0).head<3>()) * Eigen::Vector3d::UnitZ())};
    node.X_map_sensor = i == 0 ? X : Pose::Identity();
    known.graph.nodes.push_back(node);
  }
  known.graph.tilt_sigma = std::max(tilt, 1e-4);
  for (std::size_t i = 1; i < count; ++i) {
    for (std::size_t back = 1; back <= links && back <= i; ++back) {
      add_edge(known, i - back, i, 0.99, noise(random, turn, shift), turn, shift);
    }
  }
  for (std::size_t i = 0; i + 1 < links + 1; ++i) {
    add_edge(known, i, count - 1, 0.99, noise(random, turn, shift), turn, shift);
  }
  return known;
}

/// How far a pose is from the truth, metres.
inline double shift_of(const Pose& pose, const Pose& truth) {
  return (pose.translation() - truth.translation()).norm();
}

}  // namespace scanway::testing
