// A sweep that is taken out of the graph holds nothing and bends nothing.
#include "modules/mapper/core/graph/seams.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/modules/mapper/core/graph/random_graph.h"

namespace scanway {
namespace {

using testing::circle;
using testing::KnownGraph;

std::size_t seams_of(const PoseGraph& graph) {
  return static_cast<std::size_t>(
      std::count_if(graph.edges.begin(), graph.edges.end(), [](const GraphEdge& edge) { return edge.seam; }));
}

/// The graph as if the node had never had an edge, and its own pose stood.
PoseGraph without(PoseGraph graph, std::size_t node) {
  graph.nodes[node].up.reset();
  std::erase_if(graph.edges, [&](const GraphEdge& edge) { return edge.from == node || edge.to == node; });
  return graph;
}

/// How far the poses of all other nodes differ as seen from node `from`.
double difference(const GraphSolution& a, const GraphSolution& b, std::size_t from, std::size_t node) {
  double most = 0.0;
  for (std::size_t i = 0; i < std::min(a.poses.size(), b.poses.size()); ++i) {
    if (i == node) continue;
    const Pose in_a = a.poses[from].inverse() * a.poses[i], in_b = b.poses[from].inverse() * b.poses[i];
    most = std::max(most, (in_a.matrix() - in_b.matrix()).cwiseAbs().maxCoeff());
  }
  return most;
}

TEST(Seams, ANodeThatIsTakenOutBendsNothingAnyMore) {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    for (const std::size_t node : {0u, 1u, 5u, 9u}) {
      PoseGraph graph = circle(10, 3, seed, 2e-3, 1e-2).graph;
      for (GraphEdge& edge : graph.edges) {  // of all that it says, nothing is quite right
        if (edge.from == node || edge.to == node) edge.T_from_to.translation().x() += 0.02;
      }
      const std::size_t other = node == 0 ? 1 : 0;
      PoseGraph never = without(graph, node);
      GraphSolution solution = solve(graph);
      if (node == 0) never.nodes[1].X_map_sensor = solution.poses[1];
      const GraphSolution bent = solution;
      take_out(node, graph, solution);
      ASSERT_EQ(solution.dropped.size(), graph.edges.size());
      EXPECT_EQ(difference(solution, bent, other, node), 0.0) << "until it is solved anew, poses stay";
      EXPECT_EQ(seams_of(graph), 1u) << "the node itself goes with the rest";
      const GraphSolution anew = solve(graph);
      EXPECT_GT(difference(anew, bent, other, node), 1e-4) << "else the test shows nothing";
      if (node == 0) continue;  // without it `never` has no first pose to hold it
      EXPECT_LT(difference(anew, solve(never), other, node), 1e-6) << seed << ' ' << node;
    }
  }
}

/// Two loops that meet in one node.
KnownGraph two_loops(std::size_t each, std::uint64_t seed) {
  KnownGraph both = circle(2 * each + 1, 1, seed, 1e-3, 5e-3);
  both.graph.edges.clear();
  Random random(seed + 50);
  const auto link = [&](std::size_t a, std::size_t b) {
    testing::add_edge(both, a, b, 0.99, testing::noise(random, 1e-3, 5e-3), 1e-3, 5e-3);
  };
  for (std::size_t i = 0; i < 2 * each; ++i) link(i, i + 1);
  link(0, each);
  link(each, 2 * each);
  return both;
}

TEST(Seams, WhereTheRestWouldFallApartItStaysAsItLies) {
  constexpr std::size_t kEach = 4;
  KnownGraph known = two_loops(kEach, 3);
  PoseGraph graph = known.graph;
  GraphSolution solution = solve(graph);
  const GraphSolution before = solution;
  take_out(kEach, graph, solution);
  EXPECT_EQ(seams_of(graph), 2u);
  const GraphSolution held = solve(graph);
  for (const GraphEdge& edge : graph.edges) {
    const Pose was = before.poses[edge.from].inverse() * before.poses[edge.to];
    const Pose is = held.poses[edge.from].inverse() * held.poses[edge.to];
    EXPECT_TRUE(!edge.seam || (is.matrix() - was.matrix()).cwiseAbs().maxCoeff() < 2e-3);
  }
  release_seams(graph, solution);
  EXPECT_EQ(seams_of(graph), 2u) << "nothing else joins the parts";

  // A sweep that sees both parts says how they lie: there is one seam left, which holds the node alone.
  testing::add_edge(known, 1, 2 * kEach - 1, 0.99, Vector6::Zero(), 1e-3, 5e-3);
  graph.edges.push_back(known.graph.edges.back());
  release_seams(graph, solution);
  EXPECT_EQ(seams_of(graph), 1u);
  EXPECT_EQ(solution.dropped.size() + 1, graph.edges.size());
  const GraphSolution joined = solve(graph);
  const GraphEdge& link = graph.edges.back();
  const Pose T = joined.poses[link.from].inverse() * joined.poses[link.to];
  EXPECT_LT((T.matrix() - link.T_from_to.matrix()).cwiseAbs().maxCoeff(), 1e-3) << "nothing contradicts it";
}

TEST(Seams, EdgesThatWereDroppedHoldNothing) {
  KnownGraph known = circle(6, 2, 5, 1e-3, 5e-3);
  Vector6 wrong = Vector6::Zero();
  wrong[3] = 3.0;
  testing::add_edge(known, 1, 4, 0.9, wrong, 1e-3, 5e-3);
  PoseGraph graph = known.graph;
  GraphSolution solution = solve(graph);
  ASSERT_TRUE(solution.dropped.back());
  take_out(4, graph, solution);
  for (const GraphEdge& edge : graph.edges) {
    EXPECT_FALSE(edge.seam && edge.from == 1 && edge.to == 4);
  }
  EXPECT_EQ(seams_of(graph), 1u);
}

}  // namespace
}  // namespace scanway
