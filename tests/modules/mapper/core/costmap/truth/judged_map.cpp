#include "tests/modules/mapper/core/costmap/truth/judged_map.h"

#include "modules/mapper/core/cloud/voxel_cloud.h"
#include "modules/mapper/core/costmap/evidence_history.h"
#include "modules/mapper/core/costmap/look.h"
#include "modules/mapper/core/costmap/paper_projection.h"

namespace scanway::testing {
namespace {

using namespace simulator;

constexpr double kMargin = 12.0;  // metres around the places: what is further away, few beams reach

Rectangle around(const WorldSweeps& taken) {
  Rectangle part{taken.world.extent.high, taken.world.extent.low};
  for (const SimulatedSweep& sweep : taken.sweeps) {
    const Eigen::Vector2d at = sweep.X_world_base.translation().head<2>();
    part.low = part.low.cwiseMin(Eigen::Vector2d(at.array() - kMargin));
    part.high = part.high.cwiseMax(Eigen::Vector2d(at.array() + kMargin));
  }
  return {part.low.cwiseMax(taken.world.extent.low), part.high.cwiseMin(taken.world.extent.high)};
}

/// The map begins where the first sweep was taken, level, ahead of it.
Pose first_place(const Pose& X_world_base) {
  Pose X = Pose::Identity();
  X.linear() = rotation_about_z(heading_of(X_world_base.linear()));
  X.translation() = X_world_base.translation();
  return X.inverse();
}

MapPoints points_of(const SimulatedSweep& taken, const Pose& X_map_base, const Robot& robot) {
  return points_in_map(taken.sweep, X_map_base, robot.laser.min_range_m, robot.laser.max_range_m);
}

void map_by_evidence(CostMap& map, const WorldSweeps& taken, const Pose& X_map_world, const Robot& robot) {
  EvidenceHistory evidence;
  SweepNumber number = 0;
  for (const SimulatedSweep& sweep : taken.sweeps) {
    const Pose X_map_base = X_map_world * sweep.X_world_base;
    const MapPoints points = points_of(sweep, X_map_base, robot);
    evidence.put(map, number++, look(points, sweep.sweep, X_map_base, robot, 1).evidence);
  }
}

void map_as_paper(CostMap& map, const WorldSweeps& taken, const Pose& X_map_world, const Robot& robot) {
  VoxelCloud cloud(robot.mapping.cloud_voxel_m);
  std::vector<Eigen::Vector3d> origins;
  for (const SimulatedSweep& sweep : taken.sweeps) {
    const MapPoints points = points_of(sweep, X_map_world * sweep.X_world_base, robot);
    cloud.put(static_cast<SweepNumber>(origins.size()), points);
    origins.push_back(points.origin);
  }
  const PointCloud registered = cloud.centroids();
  const GroundReport ground = find_ground({registered.points, {}, origins.back()}, std::nullopt, robot, 1);
  if (ground.plane) project_as_paper(map, registered, *ground.plane, robot, origins, kCostMapReach);
}

}  // namespace

WorldSweeps take_sweeps(const std::string& name, std::uint64_t seed, const SweepPlan& plan) {
  WorldSweeps taken{make_world(name, seed), {}};
  SweepConfig config;
  config.thin = plan.thin;
  config.seed = seed * 100;
  for (const Place& place : places_on_route(taken.world, plan.sweeps, plan.spacing_m, 1.0)) {
    ++config.seed;
    taken.sweeps.push_back(simulate_sweep(taken.world, place, simulated_robot(), config));
  }
  return taken;
}

JudgedMap judge(const WorldSweeps& taken, const Robot::Mapping& mapping) {
  Robot robot = simulated_robot();
  robot.mapping = mapping;
  JudgedMap judged;
  judged.X_map_world = first_place(taken.sweeps.front().X_world_base);
  judged.map.resolution_m = robot.mapping.cost_map_resolution_m;
  const auto make = robot.mapping.paper_projection ? map_as_paper : map_by_evidence;
  make(judged.map, taken, judged.X_map_world, robot);

  std::vector<tools::TrueSweep> truths;
  for (const SimulatedSweep& sweep : taken.sweeps) truths.push_back({&sweep.sweep, sweep.X_world_base});
  judged.truth = make_truth(taken.world, robot.body, judged.map.resolution_m, around(taken));
  const CellWindow window{judged.truth.resolution_m, judged.truth.low.x, judged.truth.low.y,
                          judged.truth.low.x + judged.truth.width, judged.truth.low.y + judged.truth.height};
  judged.seen = seen_ground(taken.world, robot, truths, window);
  judged.counts = compare(judged.map, judged.X_map_world, judged.truth, judged.seen);
  const std::vector<std::size_t> lost = lost_cells(judged.map, judged.X_map_world, judged.truth, judged.seen);
  for (const std::uint8_t sweeps : seen_with_air(taken.world, robot, truths, window, lost)) {
    judged.lost_in_clear_air += sweeps > 1 ? 1 : 0;
  }
  return judged;
}

}  // namespace scanway::testing
