#include "modules/mapper/core/map.h"

#include <cmath>
#include <stdexcept>
#include <utility>

#include "modules/mapper/core/costmap/embodiment.h"
#include "modules/mapper/core/costmap/paper_projection.h"

namespace scanway {
namespace {

OccupancyTreeConfig tree_config(const Robot& robot) {
  return {robot.mapping.octomap_resolution_m, robot.mapping.octomap_max_range_m, robot.mapping.octomap_discretize,
          true};
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

Map::Map(const Robot& robot, std::uint64_t seed, MapStorage storage)
    : robot_(robot),
      seed_(seed),
      storage_(std::move(storage)),
      cloud_(robot.mapping.cloud_voxel_m, storage_.bytes),
      tree_(tree_config(robot), storage_.bytes) {
  cost_map_.resolution_m = robot.mapping.cost_map_resolution_m;
}

Pose Map::first_pose(const Sweep& sweep) const {
  Pose X_map_sweep = levelled(sweep);
  const MapPoints points = points_of(sweep, X_map_sweep);
  const GroundReport ground = find_ground(points, sweep.sensor_height_m, robot_, seed_);
  if (ground.plane) {
    X_map_sweep.translation().z() = -ground.plane->height_at(points.origin.x(), points.origin.y());
  } else if (sweep.sensor_height_m) {
    X_map_sweep.translation().z() = *sweep.sensor_height_m - points.origin.z();
  }
  return X_map_sweep;
}

MapPoints Map::points_of(const Sweep& sweep, const Pose& X_map_sweep) const {
  return points_in_map(sweep, X_map_sweep, robot_.laser.min_range_m, robot_.laser.max_range_m);
}

MapChange Map::merge(const Sweep& sweep, const Pose& X_map_sweep, StageListener* stages,
                     const std::vector<SweepMove>& moves) {
  if (!moves.empty()) begin_stage(stages, "remake");
  for (const SweepMove& move : moves) put_again(move);
  tree_.settle();

  begin_stage(stages, "merge");
  const SweepNumber number = sweeps_++;
  storage_.sweeps->keep(sweep);
  const MapPoints points = points_of(sweep, X_map_sweep);
  origins_.emplace(number, points.origin);
  cloud_.put(number, points);

  begin_stage(stages, "octomap");
  tree_.insert(points);

  begin_stage(stages, "ground");
  if (robot_.mapping.paper_projection) return close_version(project_by_paper(stages), stages);
  const Look seen = look(points, sweep, X_map_sweep, robot_, seed_, stages);
  return close_version({seen.ground, evidence_.put(cost_map_, number, seen.evidence)}, stages);
}

MapChange Map::move(const std::vector<SweepMove>& moves, StageListener* stages) {
  begin_stage(stages, "remake");
  for (const SweepMove& move : moves) put_again(move);
  return settle(stages);
}

MapChange Map::withdraw(SweepNumber sweep, StageListener* stages) {
  if (!holds(sweep)) throw std::logic_error("Map: no such sweep");
  begin_stage(stages, "remake");
  origins_.erase(sweep);
  cloud_.withdraw(sweep);
  tree_.withdraw(sweep);
  evidence_.forget(sweep);
  return settle(stages);
}

void Map::put_again(const SweepMove& move) {
  if (move.sweep >= sweeps_) throw std::logic_error("Map: no such sweep");
  const Sweep sweep = storage_.sweeps->fetch(move.sweep);
  const MapPoints points = points_of(sweep, move.X_map_sweep);
  origins_.insert_or_assign(move.sweep, points.origin);
  cloud_.put(move.sweep, points);
  tree_.replace(move.sweep, points);
  if (robot_.mapping.paper_projection) return;
  evidence_.hold(move.sweep, look(points, sweep, move.X_map_sweep, robot_, seed_).evidence);
}

MapChange Map::settle(StageListener* stages) {
  tree_.settle();
  Projection projection;
  if (robot_.mapping.paper_projection) projection = project_by_paper(stages);
  if (!robot_.mapping.paper_projection) projection.changed_tiles = evidence_.settle(cost_map_);
  return close_version(std::move(projection), stages);
}

MapChange Map::close_version(Projection projection, StageListener* stages) {
  begin_stage(stages, "embodiment");
  MapChange change;
  change.ground = std::move(projection.ground);
  change.changed_tiles = embody(cost_map_, robot_, robot_.mapping.embodiment, projection.changed_tiles);
  change.changed_cloud = cloud_.take_changed_tiles();
  change.version = ++version_;
  begin_stage(stages, "");
  return change;
}

/// Of the newest sweep at which ground was found in all that was known by then; what came later changes nothing.
Map::Projection Map::project_by_paper(StageListener* stages) {
  Projection projection;
  std::vector<Eigen::Vector3d> origins;
  for (const auto& [number, origin] : origins_) origins.push_back(origin);
  PointCloud registered;
  std::optional<GroundPlane> plane;
  for (auto newest = origins_.rbegin(); newest != origins_.rend() && !plane; ++newest) {
    registered = cloud_.centroids(newest->first + 1);
    const GroundReport ground = find_ground({registered.points, {}, newest->second}, std::nullopt, robot_, seed_);
    if (newest == origins_.rbegin()) projection.ground = ground;
    plane = ground.plane;
    if (!plane) origins.pop_back();
  }
  begin_stage(stages, "cost_map");
  // All is projected anew, so all is embodied anew: every cell of the map may have changed.
  const CostMap before = std::exchange(cost_map_, CostMap{cost_map_.resolution_m, 0.0, 0.0, {}});
  if (plane) project_as_paper(cost_map_, registered, *plane, robot_, origins, kCostMapReach);
  embody(cost_map_, robot_, robot_.mapping.embodiment);
  projection.changed_tiles = differing_tiles(before, cost_map_);
  return projection;
}

}  // namespace scanway
