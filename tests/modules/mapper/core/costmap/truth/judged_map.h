#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "modules/simulator/core/simulator.h"
#include "modules/tools/compare/cells/map_comparison.h"

namespace scanway::testing {

/// Some sweeps of one world. Their poses are the true ones: the cost map alone is judged, no registration.
struct WorldSweeps {
  simulator::World world;
  std::vector<simulator::SimulatedSweep> sweeps;
};

struct SweepPlan {
  int sweeps = 3;
  double spacing_m = 5.0;  ///< Along the world's route.
  int thin = 1;            ///< Only every thin-th line, and of it every thin-th beam.
};

WorldSweeps take_sweeps(const std::string& world, std::uint64_t seed, const SweepPlan& plan);

/// A cost map of sweeps beside the truth, on the truth's cells.
struct JudgedMap {
  CostMap map;
  Pose X_map_world = Pose::Identity();
  simulator::TruthGrid truth;
  tools::SeenGround seen;
  tools::MapComparison counts;
  std::int64_t lost_in_clear_air = 0;  ///< Of counts.two's lost cells: two sweeps also saw the air above.
};

/// All sweeps in their order, as Map lays them over each other, with what the robot file says of mapping.
JudgedMap judge(const WorldSweeps& taken, const Robot::Mapping& mapping = {});

}  // namespace scanway::testing
