#include "modules/simulator/core/simulator.h"

#include <stdexcept>

namespace scanway::simulator {

SimulatedSweep simulate_sweep(const World& world, const Place& place, const Robot& robot, const SweepConfig& config) {
  const Stand stand = stand_at(world, robot, place);
  if (!stand.problem.empty()) throw std::invalid_argument("the robot would stand " + stand.problem);
  LabelledSweep points = points_of(simulate_lines(world, robot, stand.X_world_base, config), robot);
  points.sweep.name = world.name;
  points.sweep.R_world_sweep = Tracker(robot.tracker, stand.X_world_base, config.seed).mean();
  return {std::move(points.sweep), std::move(points.labels), stand.X_world_base};
}

SimulatedSweep simulate_sweep(const World& world, const Place& place, const Robot& robot, std::uint64_t seed) {
  SweepConfig config;
  config.seed = seed;
  return simulate_sweep(world, place, robot, config);
}

}  // namespace scanway::simulator
