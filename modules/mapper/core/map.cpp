#include "modules/mapper/core/map.h"

#include <cmath>
#include <utility>

#include "modules/mapper/core/costmap/embodiment.h"
#include "modules/mapper/core/costmap/paper_projection.h"
#include "modules/mapper/core/costmap/sweep_view.h"
#include "modules/mapper/core/ground/ground_surface.h"

namespace scanway {
namespace {

constexpr double kCostMapReach = 30.0;  // metres from a sensor: what is further away is not drawn at 1 cm

GroundSurfaceConfig surface_config(const Robot& robot) {
  return {robot.body.climbable_step_m, robot.body.climbable_slope, robot.laser.range_sigma_m, kCostMapReach};
}

SweepViewConfig view_config(const Robot& robot) {
  return {robot.body.height_m, robot.body.climbable_step_m, robot.laser.range_sigma_m, robot.laser.divergence,
          kCostMapReach};
}

Pose levelled(const Sweep& sweep) {
  Pose X = Pose::Identity();
  if (!sweep.R_world_sweep) return X;
  const Eigen::Matrix3d R_world_sweep = sweep.R_world_sweep->normalized().toRotationMatrix();
  X.linear() = rotation_about_z(-heading_of(R_world_sweep)) * R_world_sweep;
  return X;
}

std::vector<Cell> differing_tiles(const CostMap& before, const CostMap& after) {
  std::vector<Cell> differing;
  auto old = before.tiles.begin();
  for (const auto& [index, tile] : after.tiles) {
    for (; old != before.tiles.end() && old->first < index; ++old) differing.push_back(old->first);
    const bool known = old != before.tiles.end() && old->first == index;
    if (!known || !(old->second == tile)) differing.push_back(index);
    if (known) ++old;
  }
  for (; old != before.tiles.end(); ++old) differing.push_back(old->first);
  return differing;
}

}  // namespace

Map::Map(const Robot& robot, std::uint64_t seed)
    : robot_(robot),
      seed_(seed),
      cloud_(robot.mapping.cloud_voxel_m),
      tree_({robot.mapping.octomap_resolution_m, robot.mapping.octomap_max_range_m, robot.mapping.octomap_discretize}) {
  cost_map_.resolution_m = robot.mapping.cost_map_resolution_m;
}

Pose Map::first_pose(const Sweep& sweep) const {
  Pose X_map_sweep = levelled(sweep);
  const MapPoints points = points_in_map(sweep, X_map_sweep, robot_.laser.min_range_m, robot_.laser.max_range_m);
  const GroundReport ground = find_ground(points, sweep);
  if (ground.plane) {
    X_map_sweep.translation().z() = -ground.plane->height_at(points.origin.x(), points.origin.y());
  } else if (sweep.sensor_height_m) {
    X_map_sweep.translation().z() = *sweep.sensor_height_m - points.origin.z();
  }
  return X_map_sweep;
}

GroundReport Map::find_ground(const MapPoints& points, const Sweep& sweep) const {
  GroundPlaneConfig config;
  config.max_slope = robot_.body.climbable_slope;
  config.inlier_m = robot_.body.climbable_step_m + robot_.laser.range_sigma_m;
  config.seed = seed_;
  GroundReport report;
  if (sweep.sensor_height_m) config.sensor_height_m = *sweep.sensor_height_m;
  report.plane = find_ground_plane(points, config);
  if (report.plane) {
    const Eigen::Vector3d& o = points.origin;
    report.sensor_height_m = o.z() - report.plane->height_at(o.x(), o.y());
    report.note = "ground found";
  } else if (sweep.sensor_height_m) {
    report.note = "no ground found where the sensor's height puts it";
  } else {
    report.note = "no ground found";
  }
  return report;
}

MapChange Map::merge(const Sweep& sweep, const Pose& X_map_sweep, StageListener* stages) {
  begin_stage(stages, "merge");
  const MapPoints points = points_in_map(sweep, X_map_sweep, robot_.laser.min_range_m, robot_.laser.max_range_m);
  origins_.push_back(points.origin);
  cloud_.add(points);

  begin_stage(stages, "octomap");
  tree_.insert(points);

  const Projection projection = project(points, sweep, X_map_sweep, stages);

  begin_stage(stages, "embodiment");
  MapChange change;
  change.ground = projection.ground;
  change.changed_tiles = embody(cost_map_, robot_, robot_.mapping.embodiment, projection.changed_tiles);
  change.version = ++version_;
  begin_stage(stages, "");
  return change;
}

void Map::succeed(const Map& before, MapChange& change) {
  change.changed_tiles = differing_tiles(before.cost_map_, cost_map_);
  change.version = version_ = before.version_ + 1;
}

Map::Projection Map::project(const MapPoints& points, const Sweep& sweep, const Pose& X_map_sweep,
                             StageListener* stages) {
  begin_stage(stages, "ground");
  if (robot_.mapping.paper_projection) return project_by_paper(points, stages);
  return project_by_evidence(points, sweep, X_map_sweep, stages);
}

Map::Projection Map::project_by_paper(const MapPoints& points, StageListener* stages) {
  const PointCloud registered = cloud_.centroids();
  Projection projection{find_ground({registered.points, {}, points.origin}, Sweep{}), {}};
  begin_stage(stages, "cost_map");
  if (!projection.ground.plane) return projection;
  // All is projected anew, so all is embodied anew: every cell of the map may have changed.
  const CostMap before = std::exchange(cost_map_, CostMap{cost_map_.resolution_m, 0.0, 0.0, {}});
  project_as_paper(cost_map_, registered, *projection.ground.plane, robot_, origins_, kCostMapReach);
  embody(cost_map_, robot_, robot_.mapping.embodiment);
  projection.changed_tiles = differing_tiles(before, cost_map_);
  return projection;
}

Map::Projection Map::project_by_evidence(const MapPoints& points, const Sweep& sweep, const Pose& X_map_sweep,
                                         StageListener* stages) {
  Projection projection{find_ground(points, sweep), {}};
  GroundReport& ground = projection.ground;
  if (!ground.plane) return projection;
  const GroundSurface surface(points, *ground.plane, surface_config(robot_));
  ground.surface_area_m2 = surface.area_m2();

  begin_stage(stages, "cost_map");
  const SweepViewConfig config = view_config(robot_);
  const std::vector<ObstacleReturn> obstacles = obstacle_returns(points, surface, config);
  const SweepView view(points, surface, obstacles, config);
  projection.changed_tiles =
      evidence_.put(cost_map_, origins_.size(),
                    gather_evidence(obstacles, surface, view, robot_.body, X_map_sweep, cost_map_.resolution_m));
  return projection;
}

}  // namespace scanway
