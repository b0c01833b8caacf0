#pragma once

#include "modules/simulator/core/laser/raw_sweep.h"
#include "modules/simulator/core/laser/robot_body.h"
#include "modules/simulator/core/stand.h"
#include "modules/simulator/core/tracker.h"
#include "modules/simulator/core/truth/truth_grid.h"
#include "modules/simulator/core/world/world.h"

/// The simulator as tests and benches use it: a world, a place to stand, a sweep with its truth.
namespace scanway::simulator {

struct SimulatedSweep {
  Sweep sweep;                ///< In `base`, with the tracker's orientation.
  std::vector<Label> labels;  ///< One a point.
  Pose X_world_base = Pose::Identity();
};

/// A sweep of the robot at `place`, whose z, roll and pitch follow the ground. Throws std::invalid_argument when the
/// robot cannot stand there.
SimulatedSweep simulate_sweep(const World& world, const Place& place, const Robot& robot, const SweepConfig& config);
SimulatedSweep simulate_sweep(const World& world, const Place& place, const Robot& robot, std::uint64_t seed);

}  // namespace scanway::simulator
