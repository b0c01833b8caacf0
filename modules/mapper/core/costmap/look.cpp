#include "modules/mapper/core/costmap/look.h"

#include <vector>

#include "modules/mapper/core/costmap/drop_view.h"
#include "modules/mapper/core/costmap/obstacle_returns.h"
#include "modules/mapper/core/costmap/sweep_view.h"
#include "modules/mapper/core/costmap/vegetation.h"
#include "modules/mapper/core/ground/ground_surface.h"

namespace scanway {
namespace {

constexpr double kLeastLevel = 2.0;  // square metres: more than a pallet

GroundSurfaceConfig surface_config(const Robot& robot) {
  return {robot.body.climbable_step_m, robot.body.climbable_slope, robot.laser.range_sigma_m, kCostMapReach,
          kLeastLevel};
}

SweepViewConfig view_config(const Robot& robot) {
  return {robot.body.height_m,    robot.body.climbable_step_m, robot.laser.range_sigma_m,
          robot.laser.divergence, robot.body.climbable_slope,  kCostMapReach};
}

std::optional<SoftGround> soft_ground(const MapPoints& points, const GroundSurface& surface, const Robot& robot) {
  if (robot.mapping.vegetation == Vegetation::ignore) return std::nullopt;
  return SoftGround(GroundPatches(points, surface), robot.laser.range_sigma_m);
}

/// The directions, in the map, of the beams that met nothing.
std::vector<Eigen::Vector3f> missing_beams(const Sweep& sweep, const Pose& X_map_sweep) {
  std::vector<Eigen::Vector3f> directions;
  for (const BeamFan& fan : sweep.no_return) {
    for (int i = 0; i < fan.beams; ++i) {
      const Eigen::Vector3d d = fan.direction(i);
      Eigen::Vector3d turned;
      for (int row = 0; row < 3; ++row) {
        turned[row] = (X_map_sweep(row, 0) * d.x() + X_map_sweep(row, 1) * d.y()) + X_map_sweep(row, 2) * d.z();
      }
      if (turned.z() < 0.0) directions.push_back(turned.cast<float>());
    }
  }
  return directions;
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
  report.height_known = sensor_height_m.has_value();
  if (report.plane) {
    const Eigen::Vector3d& o = points.origin;
    report.sensor_height_m = o.z() - report.plane->height_at(o.x(), o.y());
  }
  return report;
}

std::string said_of(const GroundReport& ground) {
  if (ground.plane) return "";
  const std::string where = ground.height_known ? " where the sensor's height puts it" : "";
  return " No ground was found" + where + ": the cost map does not show this sweep.";
}

Look look(const MapPoints& points, const Sweep& sweep, const Pose& X_map_sweep, const Robot& robot, std::uint64_t seed,
          StageListener* stages) {
  Look seen{find_ground(points, sweep.sensor_height_m, robot, seed), {}};
  if (!seen.ground.plane) return seen;
  const GroundSurface surface(points, *seen.ground.plane, surface_config(robot));
  seen.ground.surface_area_m2 = surface.area_m2();

  begin_stage(stages, "cost_map");
  const SweepViewConfig config = view_config(robot);
  std::vector<ObstacleReturn> obstacles = obstacle_returns(points, surface, config);
  const std::optional<SoftGround> soft = soft_ground(points, surface, robot);
  if (soft && robot.mapping.vegetation == Vegetation::pass) leave_out_grass(obstacles, *soft);
  const SweepView view(points, missing_beams(sweep, X_map_sweep), surface, obstacles, config);
  const DropView drops(points, surface, config);
  seen.evidence =
      gather_evidence(obstacles, surface, view, drops, robot.body, X_map_sweep, robot.mapping.cost_map_resolution_m);
  if (soft && robot.mapping.vegetation == Vegetation::avoid) {
    occupy_soft_ground(seen.evidence, *soft, robot, X_map_sweep);
  }
  return seen;
}

}  // namespace scanway
