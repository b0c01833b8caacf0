#include "tests/bench/planning/peers/ompl/sampling.h"

#include <memory>

#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/geometric/planners/informedtrees/BITstar.h>
#include <ompl/geometric/planners/prm/PRMstar.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/Console.h>

#include "tests/bench/planning/cpu_time.h"

namespace scanway::bench {
namespace {

namespace base = ompl::base;
namespace geometric = ompl::geometric;

/// Lines are looked at this often, in cells.
constexpr double kStep = 0.25;

base::PlannerPtr planner_of(Sampler sampler, const base::SpaceInformationPtr& space) {
  if (sampler == Sampler::rrt_connect) return std::make_shared<geometric::RRTConnect>(space);
  if (sampler == Sampler::bit_star) return std::make_shared<geometric::BITstar>(space);
  return std::make_shared<geometric::PRMstar>(space);
}

/// A byte a cell, as the map's tiles would be looked up anew for each sample.
std::vector<char> free_cells(const Scene& scene) {
  std::vector<char> free;
  for (Cell cell{0, 0}; cell.y < scene.side; ++cell.y) {
    for (cell.x = 0; cell.x < scene.side; ++cell.x) free.push_back(scene.map.state(cell) == CellState::free);
  }
  return free;
}

}  // namespace

const char* name_of(Sampler sampler) {
  if (sampler == Sampler::rrt_connect) return "RRT-Connect";
  return sampler == Sampler::bit_star ? "BIT*" : "PRM*";
}

std::optional<SampledWay> sample(const Scene& scene, Sampler sampler, double most_seconds) {
  ompl::msg::setLogLevel(ompl::msg::LOG_ERROR);
  const std::vector<char> free = free_cells(scene);
  const auto space = std::make_shared<base::RealVectorStateSpace>(2);
  space->setBounds(0.0, scene.side);
  geometric::SimpleSetup setup(space);
  setup.setStateValidityChecker([&](const base::State* state) {
    const double* at = state->as<base::RealVectorStateSpace::StateType>()->values;
    const auto x = std::min(static_cast<std::int32_t>(at[0]), scene.side - 1);
    const auto y = std::min(static_cast<std::int32_t>(at[1]), scene.side - 1);
    return free[static_cast<std::size_t>(y) * static_cast<std::size_t>(scene.side) + static_cast<std::size_t>(x)] != 0;
  });
  setup.getSpaceInformation()->setStateValidityCheckingResolution(kStep / space->getMaximumExtent());
  base::ScopedState<> start(space), goal(space);
  start[0] = start[1] = 0.5;
  goal[0] = goal[1] = scene.side - 0.5;
  setup.setStartAndGoalStates(start, goal);
  setup.setOptimizationObjective(std::make_shared<base::PathLengthOptimizationObjective>(setup.getSpaceInformation()));
  setup.setPlanner(planner_of(sampler, setup.getSpaceInformation()));
  SampledWay way;
  way.ms = cpu_ms([&] {
    setup.solve(most_seconds);
    if (setup.haveExactSolutionPath()) setup.simplifySolution();
  });
  if (!setup.haveExactSolutionPath()) return std::nullopt;
  way.length = setup.getSolutionPath().length();
  return way;
}

}  // namespace scanway::bench
