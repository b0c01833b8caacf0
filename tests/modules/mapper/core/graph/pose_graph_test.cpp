#include "modules/mapper/core/graph/pose_graph.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/modules/mapper/core/graph/random_graph.h"

namespace scanway {
namespace {

using testing::circle;
using testing::KnownGraph;
using testing::shift_of;

std::size_t dropped_count(const GraphSolution& solution) {
  return static_cast<std::size_t>(std::count(solution.dropped.begin(), solution.dropped.end(), true));
}

TEST(PoseGraph, WithoutNoiseItGivesTheTruth) {
  const KnownGraph known = circle(12, 2, 1, 1e-3, 5e-3);
  KnownGraph exact = known;
  for (GraphEdge& edge : exact.graph.edges) {
    edge.T_from_to = exact.truth[edge.from].inverse() * exact.truth[edge.to];
  }
  for (std::size_t i = 0; i < exact.truth.size(); ++i) {
    exact.graph.nodes[i].up = exact.truth[i].linear().transpose() * Eigen::Vector3d::UnitZ();
  }
  const GraphSolution solution = solve(exact.graph);
  EXPECT_NEAR(solution.cost, 0.0, 1e-9);
  for (std::size_t i = 0; i < exact.truth.size(); ++i) {
    EXPECT_LT(shift_of(solution.poses[i], exact.truth[i]), 1e-7) << i;
    EXPECT_LT(rotation_angle(solution.poses[i].linear().transpose() * exact.truth[i].linear()), 1e-8) << i;
  }
}

/// The cost of poses, written down anew.
double cost_at(const PoseGraph& graph, const std::vector<Pose>& poses) {
  double cost = 0.0;
  for (const GraphEdge& edge : graph.edges) {
    const Pose T = poses[edge.from].inverse() * poses[edge.to];
    Vector6 r;
    r << log_so3(T.linear() * edge.T_from_to.linear().transpose()), T.translation() - edge.T_from_to.translation();
    cost += r.dot(edge.covariance.ldlt().solve(r));
  }
  Eigen::Vector3d up = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < poses.size(); ++i) up += poses[i].linear() * *graph.nodes[i].up;
  up.normalize();
  for (std::size_t i = 0; i < poses.size(); ++i) {
    cost += (poses[i].linear() * *graph.nodes[i].up - up).squaredNorm() / (graph.tilt_sigma * graph.tilt_sigma);
  }
  return cost;
}

TEST(PoseGraph, NoStepLeadsLower) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const KnownGraph known = circle(10, 3, seed, 2e-3, 1e-2);
    const GraphSolution solution = solve(known.graph);
    ASSERT_EQ(dropped_count(solution), 0u) << seed;
    const double cost = cost_at(known.graph, solution.poses);
    EXPECT_NEAR(solution.cost, cost, 1e-6 * cost) << seed;
    for (std::size_t i = 1; i < solution.poses.size(); ++i) {
      for (int k = 0; k < 6; ++k) {
        for (const double step : {-1e-5, 1e-5}) {
          std::vector<Pose> poses = solution.poses;
          poses[i] = testing::disturbed(poses[i], step * Vector6::Unit(k));
          EXPECT_GT(cost_at(known.graph, poses), cost - 1e-7 * cost) << seed << " node " << i << " direction " << k;
        }
      }
    }
  }
}

TEST(PoseGraph, ClosingALoopTakesTheDriftOut) {
  double open = 0.0, closed = 0.0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    KnownGraph known = circle(40, 1, seed, 1e-3, 5e-3);
    const GraphSolution solution = solve(known.graph);
    EXPECT_EQ(dropped_count(solution), 0u) << seed;
    closed += shift_of(solution.poses[39], known.truth[39]);
    known.graph.edges.pop_back();
    open += shift_of(solve(known.graph).poses[39], known.truth[39]);
  }
  EXPECT_LT(closed, 0.2 * open);
}

TEST(PoseGraph, AFalseEdgeAnywhereIsFoundAndNothingElse) {
  Random random(7);
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    KnownGraph known = circle(12, 2, seed, 1e-3, 5e-3);
    const GraphSolution clean = solve(known.graph);
    Vector6 wrong = testing::noise(random, 0.05, 1.0);
    wrong.tail<3>() += Eigen::Vector3d(0.4, 0.0, 0.0);
    const std::size_t from = seed % 11, to = from + 1 + seed % (11 - from);
    add_edge(known, from, to, 0.9999, wrong, 1e-3, 5e-3);
    const GraphSolution solution = solve(known.graph);
    EXPECT_TRUE(solution.dropped.back()) << seed;
    EXPECT_EQ(dropped_count(solution), 1u) << seed;
    for (std::size_t i = 0; i < 12; ++i) EXPECT_LT(shift_of(solution.poses[i], clean.poses[i]), 1e-6);
  }
}

TEST(PoseGraph, TheTreeIsDoubtedToo) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    KnownGraph known = circle(12, 2, seed, 1e-3, 5e-3);
    GraphEdge& false_one = known.graph.edges[2 * seed];  // the most probable of all, so the tree holds it
    false_one.probability = 0.9999;
    false_one.T_from_to.translation().y() += 3.2;
    const GraphSolution solution = solve(known.graph);
    EXPECT_TRUE(solution.dropped[2 * seed]) << seed;
    EXPECT_EQ(dropped_count(solution), 1u) << seed;
  }
}

TEST(PoseGraph, OfTwoThatContradictEachOtherTheLessProbableGoes) {
  KnownGraph known = circle(3, 1, 3, 1e-3, 5e-3);  // a triangle: any of its edges could be the wrong one
  known.graph.edges[0].T_from_to.translation().x() += 1.0;
  for (const std::size_t weak : {0u, 1u, 2u}) {
    for (std::size_t e = 0; e < 3; ++e) known.graph.edges[e].probability = e == weak ? 0.9 : 0.99;
    const GraphSolution solution = solve(known.graph);
    for (std::size_t e = 0; e < 3; ++e) EXPECT_EQ(solution.dropped[e], e == weak) << weak;
  }
}

TEST(PoseGraph, SeveralFalseEdges) {
  Random random(9);
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    KnownGraph known = circle(20, 3, seed, 1e-3, 5e-3);
    const std::size_t right = known.graph.edges.size();
    for (std::size_t k = 0; k < 6; ++k) {
      const std::size_t from = (3 * k + seed) % 18;
      add_edge(known, from, from + 2, 0.99, testing::noise(random, 0.3, 5.0), 1e-3, 5e-3);
    }
    const GraphSolution solution = solve(known.graph);
    for (std::size_t e = 0; e < solution.dropped.size(); ++e) EXPECT_EQ(solution.dropped[e], e >= right) << seed;
  }
}

TEST(PoseGraph, WhatNoEdgeHoldsStaysAndASingleNodeIsASolution) {
  PoseGraph graph;
  graph.nodes.resize(3);
  graph.nodes[2].X_map_sensor.translation() << 1.0, 2.0, 3.0;
  const GraphSolution solution = solve(graph);
  EXPECT_LT(shift_of(solution.poses[2], graph.nodes[2].X_map_sensor), 1e-12);
  graph.nodes.resize(1);
  EXPECT_EQ(solve(graph).poses.size(), 1u);
}

}  // namespace
}  // namespace scanway
