#pragma once

#include <cstdint>
#include <string>

#include "common/robot/robot.h"
#include "modules/planner/core/planner.h"

namespace scanway::test {

/// A planner that lives through random changes of a random map, of its start and of its goal.
struct RepairCase {
  const char* name;
  planning::BodyMode mode;
  UnknownPolicy unknown;
  std::int32_t side;
  int steps;
};

/// Expects that every repaired plan costs what the Dijkstra of the tests says and what a planner that starts from
/// nothing finds: with a footprint in every step, else in every eighth.
void expect_repairs_to_cost_what_full_searches_do(const RepairCase& repair, std::uint64_t seed);

/// What changes near the robot took, and what planning anew took for the same.
struct NearRobotEffort {
  std::uint64_t expansions = 0;
  std::uint64_t dropped = 0;
  std::uint64_t expansions_anew = 0;
  int changes = 0;
};

/// The robot drives along every `stride`-th of the last 100 problems of a Moving AI map. At the start and after 20, 40
/// and 60 % of the way, a cell, then a block of 3 x 3 cells, appears on its path, at most 28 cells ahead, and vanishes
/// again. Expects the cost of a new planner every time.
NearRobotEffort change_near_robot(const std::string& name, std::size_t stride);

}  // namespace scanway::test
