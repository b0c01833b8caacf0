// Twelve sweeps round a block, and back where they began.
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "modules/mapper/core/mapper.h"
#include "modules/simulator/core/simulator.h"

namespace scanway {
namespace {

constexpr int kSweeps = 12;

struct Round {
  Mapper mapper{Robot{}};
  std::vector<Sweep> sweeps;
  std::vector<Pose> truth;  // X_world_sweep of each.
};

Round drive(const std::string& world_name) {
  const simulator::World world = simulator::make_world(world_name, 1);
  Round round;
  for (const simulator::Place& place : simulator::places_on_route(world, kSweeps)) {
    const auto number = round.sweeps.size();
    auto simulated = simulator::simulate_sweep(world, place, Robot{}, {.seed = 100 + number, .thin = 2});
    simulated.sweep.name = std::to_string(number);
    round.sweeps.push_back(std::move(simulated.sweep));
    round.truth.push_back(simulated.X_world_base);
    const SweepResult result = round.mapper.add(round.sweeps.back());
    EXPECT_EQ(result.verdict, Verdict::accepted) << number << ": " << result.reason;
  }
  return round;
}

/// Driven once for all tests.
const Round& round_in(const std::string& world_name) {
  static std::map<std::string, Round> rounds;
  const auto known = rounds.find(world_name);
  return known != rounds.end() ? known->second : rounds.emplace(world_name, drive(world_name)).first->second;
}

/// Of a sweep's place, seen from the first one's.
double error_m(const Round& round, std::size_t sweep) {
  const auto& placed = round.mapper.graph().sweeps();
  const Pose truth = round.truth.front().inverse() * round.truth[sweep];
  return (truth.inverse() * (placed.front().X_map_sweep.inverse() * placed[sweep].X_map_sweep)).translation().norm();
}

class Loop : public testing::TestWithParam<const char*> {};

TEST_P(Loop, EndsWhereItIs) {
  const Round& round = round_in(GetParam());
  const auto& placed = round.mapper.graph().sweeps();
  ASSERT_EQ(placed.size(), round.truth.size());
  EXPECT_LT(error_m(round, placed.size() - 1), 0.02);
  for (std::size_t i = 1; i < placed.size(); ++i) {
    RecordProperty("error_mm_" + std::to_string(i), static_cast<int>(1000.0 * error_m(round, i)));
  }
}

/// How an edge may be wrong: a bay's width along, half a metre aside, a few degrees about.
struct Wrong {
  Eigen::Vector3d shift;
  double turn;
};

TEST_P(Loop, AFalseEdgeIsFoundAndDropped) {
  const Round& round = round_in(GetParam());
  const GraphSolution& before = round.mapper.graph().solution();
  const PoseGraph& known = round.mapper.graph().graph();
  ASSERT_EQ(known.nodes.size(), round.truth.size());
  for (const auto& [from, to] : {std::pair<std::size_t, std::size_t>{2, 8}, {0, 11}, {5, 6}, {3, 9}}) {
    for (const Wrong& by : {Wrong{{2.5, 0.0, 0.0}, 0.0}, {{0.0, 0.5, 0.0}, 0.0}, {{0.3, 0.3, 0.0}, 0.1}}) {
      GraphEdge wrong = known.edges.front();  // As sure of itself as a right one.
      wrong.from = from;
      wrong.to = to;
      wrong.T_from_to = before.poses[from].inverse() * before.poses[to];
      wrong.T_from_to.translation() += by.shift;
      wrong.T_from_to.linear() = rotation_about_z(by.turn) * wrong.T_from_to.linear();
      PoseGraph graph = known;
      graph.edges.push_back(wrong);
      const GraphSolution solution = solve(graph);
      EXPECT_TRUE(solution.dropped.back()) << from << " to " << to;
      for (std::size_t e = 0; e < known.edges.size(); ++e) EXPECT_EQ(solution.dropped[e], before.dropped[e]) << e;
      for (std::size_t i = 0; i < before.poses.size(); ++i) {
        EXPECT_LT((solution.poses[i].translation() - before.poses[i].translation()).norm(), 1e-4) << i;
      }
    }
  }
}

TEST_P(Loop, TheMapIsWhatItsSweepsGiveAtTheirLastPoses) {
  const Round& round = round_in(GetParam());
  Map anew(Robot{}, 1);
  ASSERT_EQ(round.mapper.trajectory().size(), round.sweeps.size());
  for (std::size_t i = 0; i < round.sweeps.size(); ++i) {
    anew.merge(round.sweeps[i], round.mapper.trajectory()[i].X_map_sweep);
  }
  EXPECT_TRUE(anew.cost_map().tiles == round.mapper.map().cost_map().tiles);
  EXPECT_TRUE(anew.occupancy_tree().ot_bytes() == round.mapper.map().occupancy_tree().ot_bytes());
  EXPECT_EQ(round.mapper.map().version(), round.sweeps.size());
}

INSTANTIATE_TEST_SUITE_P(Worlds, Loop, testing::Values("street", "car_park"));

}  // namespace
}  // namespace scanway
