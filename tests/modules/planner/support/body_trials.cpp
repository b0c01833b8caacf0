#include "tests/modules/planner/support/body_trials.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>

#include "common/grid/map_file.h"
#include "modules/simulator/core/truth/truth_grid.h"
#include "modules/simulator/core/world/world.h"
#include "tests/modules/planner/support/polygon_check.h"
#include "tests/modules/planner/support/reference.h"

namespace scanway::test {
namespace {

using planning::BodyMode;
using planning::PathForm;
using planning::PathPose;
using planning::Planner;
using planning::PlanResult;
using planning::PlanStatus;

Robot box(double front, double back, double half_width) {
  Robot robot;
  robot.body.footprint = {{front, half_width}, {-back, half_width}, {-back, -half_width}, {front, -half_width}};
  return robot;
}

/// A cell where the body has room at a random heading; after a while, any cell.
Cell place_for(const TestMap& map, const PolygonCheck& check, Random& random) {
  Cell cell;
  for (int i = 0; i < 300; ++i) {
    cell = random_cell(map.bounds, random);
    const double heading = static_cast<double>(random.below(8)) * std::numbers::pi / 4.0;
    if (!check.blocks(cell) && !check.hits({cell.x, cell.y}, heading)) break;
  }
  return cell;
}

/// Each metre of the path at its weight, in steps of a hundredth of a cell; turns left out.
double cost_along(const TestMap& map, const Robot& robot, const std::vector<PathPose>& path) {
  double cost = 0.0;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const Eigen::Vector2d a(path[i].x_m, path[i].y_m), b(path[i + 1].x_m, path[i + 1].y_m);
    const int parts = 1 + static_cast<int>(100.0 * (b - a).norm() / map.map.resolution_m);
    const bool backwards = path[i].speed_m_s < 0.0 || path[i + 1].speed_m_s < 0.0;
    for (int part = 0; part < parts; ++part) {
      const Eigen::Vector2d at = (a + (b - a) * ((part + 0.5) / parts)) / map.map.resolution_m;
      const Cell cell = {static_cast<std::int32_t>(std::floor(at.x())), static_cast<std::int32_t>(std::floor(at.y()))};
      const double price = weight_of(map, robot, BodyMode::footprint, cell);
      cost += (backwards ? 2.0 : 1.0) * price * (b - a).norm() / parts;
    }
  }
  return cost;
}

void expect_good(const TestMap& map, const Robot& robot, const PolygonCheck& check, const PlanResult& plan) {
  EXPECT_EQ(check.first_hit(plan.path), "");
  EXPECT_EQ(fault_in_drive(plan.path, robot.body), "");
  EXPECT_LE(cost_along(map, robot, plan.path), 1.002 * plan.cost + map.map.resolution_m);
  EXPECT_GE(plan.clearance_m, 0.0);
}

void expect_ends(const PlanResult& plan, const Eigen::Vector2d& start, const Eigen::Vector2d& goal) {
  EXPECT_LT(std::hypot(plan.path.front().x_m - start.x(), plan.path.front().y_m - start.y()), 1e-9);
  EXPECT_LT(std::hypot(plan.path.back().x_m - goal.x(), plan.path.back().y_m - goal.y()), 1e-9);
}

}  // namespace

const std::vector<TrialBody>& trial_bodies() {
  static const std::vector<TrialBody> bodies = {{"era_mobi", Robot(), 0.1, 0.04},
                                                {"box", box(0.6, 0.6, 0.25), 0.15, 0.03},
                                                {"car", box(3.6, 0.9, 0.9), 0.6, 0.02}};
  return bodies;
}

TestMap truth_map(const std::string& world, std::uint64_t seed, const Robot& robot, double resolution_m) {
  const simulator::World built = simulator::make_world(world, seed);
  TestMap map{to_cost_map(simulator::make_truth(built, robot.body, resolution_m)), {}};
  map.bounds = *bounds(map.map);
  return map;
}

TestMap recorded_map(const std::string& name) {
  const std::string path = std::string(SCANWAY_SHARED_DIR) + "/data/occupancy_maps/" + name + ".yaml";
  if (!std::filesystem::exists(path)) return {};
  TestMap map{read_map(path), {}};
  map.bounds = *bounds(map.map);
  return map;
}

Tally try_random_problems(const TestMap& map, const Robot& robot, int problems, Random& random,
                          std::optional<PathForm> form) {
  Planner planner(robot, BodyMode::footprint, form);
  planner.set_map(map.map, map.bounds);
  const PolygonCheck check(map, robot);
  Tally tally;
  for (int i = 0; i < problems; ++i) {
    const Eigen::Vector2d start = middle_of(map.map, place_for(map, check, random));
    const Eigen::Vector2d goal = middle_of(map.map, place_for(map, check, random));
    const PlanResult plan = planner.plan(start, goal);
    (plan.status == PlanStatus::ok ? tally.ways : tally.none) += 1;
    tally.cost += plan.cost;
    if (plan.status != PlanStatus::ok) continue;
    tally.seconds += plan.path.back().time_s;
    expect_good(map, robot, check, plan);
    expect_ends(plan, start, goal);
  }
  return tally;
}

Tally try_against_exhaustive_search(const TrialBody& body, int maps, Random& random) {
  Tally tally;
  for (int i = 0; i < maps; ++i) {
    const TestMap map = random_map(24, 20, body.resolution_m, body.share * (1 + i % 4), i % 3 == 0, random);
    const PolygonCheck check(map, body.robot);
    const Cell start = place_for(map, check, random), goal = place_for(map, check, random);
    Planner planner(body.robot, BodyMode::footprint);
    planner.set_map(map.map, map.bounds);
    const PlanResult plan = planner.plan(middle_of(map.map, start), middle_of(map.map, goal));
    const auto of_8 = dijkstra_cost_of_body(map, body.robot, start, goal, 8);
    const auto of_16 = dijkstra_cost_of_body(map, body.robot, start, goal, 16);
    EXPECT_TRUE(!of_8 || plan.status == PlanStatus::ok) << body.name << ", map " << i << ": " << plan.reason;
    EXPECT_EQ(plan.status == PlanStatus::ok, of_16.has_value()) << body.name << ", map " << i;
    // The search samples turns and steps, and so allows a little more than the planner's exact sweeps.
    EXPECT_GE(plan.cost, of_16.value_or(0.0) - 1e-9) << body.name << ", map " << i;
    EXPECT_LE(plan.cost, 1.05 * of_16.value_or(0.0)) << body.name << ", map " << i;
    (of_16 ? tally.ways : tally.none) += 1;
  }
  return tally;
}

std::string fault_in_drive(const std::vector<PathPose>& path, const Robot::Body& body) {
  constexpr double kRounding = 1e-6;
  if (path.front().time_s != 0.0 || path.front().speed_m_s != 0.0) return "does not start from standing";
  if (path.back().speed_m_s != 0.0) return "does not end standing";
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const PathPose &a = path[i], &b = path[i + 1];
    const std::string where = " at pose " + std::to_string(i);
    const double seconds = b.time_s - a.time_s, way = std::hypot(b.x_m - a.x_m, b.y_m - a.y_m);
    const double turn = std::fabs(std::remainder(b.heading - a.heading, 2.0 * std::numbers::pi));
    if (!(seconds >= 0.0)) return "goes back in time" + where;
    if (way == 0.0 && (a.speed_m_s != 0.0 || b.speed_m_s != 0.0)) return "turns in place while it moves" + where;
    if (std::fabs(0.5 * std::fabs(a.speed_m_s + b.speed_m_s) * seconds - way) > kRounding) return "jumps" + where;
    if (std::max(std::fabs(a.speed_m_s), std::fabs(b.speed_m_s)) > body.max_speed_m_s + kRounding)
      return "speeds" + where;
    if (turn > body.max_turn_rate * seconds * (1.0 + kRounding)) return "turns too fast" + where;
    if (std::fabs(b.speed_m_s - a.speed_m_s) > body.max_acceleration_m_s2 * seconds + kRounding)
      return "speeds up too fast" + where;
    if (way > 0.0 && turn / way * a.speed_m_s * a.speed_m_s > body.max_acceleration_m_s2 * (1.0 + kRounding))
      return "takes a bend too fast" + where;
  }
  return {};
}

}  // namespace scanway::test
