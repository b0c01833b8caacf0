#include "modules/mapper/core/costmap/look.h"

#include "modules/mapper/core/costmap/obstacle_returns.h"
#include "modules/mapper/core/costmap/sweep_view.h"
#include "modules/mapper/core/ground/ground_surface.h"

namespace scanway {
namespace {

GroundSurfaceConfig surface_config(const Robot& robot) {
  return {robot.body.climbable_step_m, robot.body.climbable_slope, robot.laser.range_sigma_m, kCostMapReach};
}

SweepViewConfig view_config(const Robot& robot) {
  return {robot.body.height_m, robot.body.climbable_step_m, robot.laser.range_sigma_m, robot.laser.divergence,
          kCostMapReach};
}

}  // namespace

GroundReport find_ground(const MapPoints& points, std::optional<double> sensor_height_m, const Robot& robot,
                         std::uint64_t seed) {
  GroundPlaneConfig config;
  config.max_slope = robot.body.climbable_slope;
  config.inlier_m = robot.body.climbable_step_m + robot.laser.range_sigma_m;
  config.seed = seed;
  if (sensor_height_m) config.sensor_height_m = *sensor_height_m;
  GroundReport report;
  report.plane = find_ground_plane(points, config);
  if (report.plane) {
    const Eigen::Vector3d& o = points.origin;
    report.sensor_height_m = o.z() - report.plane->height_at(o.x(), o.y());
    report.note = "ground found";
  } else if (sensor_height_m) {
    report.note = "no ground found where the sensor's height puts it";
  } else {
    report.note = "no ground found";
  }
  return report;
}

Look look(const MapPoints& points, const Sweep& sweep, const Pose& X_map_sweep, const Robot& robot, std::uint64_t seed,
          StageListener* stages) {
  Look seen{find_ground(points, sweep.sensor_height_m, robot, seed), {}};
  if (!seen.ground.plane) return seen;
  const GroundSurface surface(points, *seen.ground.plane, surface_config(robot));
  seen.ground.surface_area_m2 = surface.area_m2();

  begin_stage(stages, "cost_map");
  const SweepViewConfig config = view_config(robot);
  const std::vector<ObstacleReturn> obstacles = obstacle_returns(points, surface, config);
  const SweepView view(points, surface, obstacles, config);
  seen.evidence = gather_evidence(obstacles, surface, view, robot.body, X_map_sweep, robot.mapping.cost_map_resolution_m);
  return seen;
}

}  // namespace scanway
