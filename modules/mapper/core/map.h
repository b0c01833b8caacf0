#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "common/cloud/sweep.h"
#include "common/geometry/pose.h"
#include "common/grid/cost_map.h"
#include "common/progress/stages.h"
#include "common/robot/robot.h"
#include "modules/mapper/core/cloud/map_points.h"
#include "modules/mapper/core/cloud/voxel_cloud.h"
#include "modules/mapper/core/costmap/evidence_history.h"
#include "modules/mapper/core/ground/ground_plane.h"
#include "modules/mapper/core/octomap/occupancy_tree.h"

namespace scanway {

/// What is known of the ground in one sweep. Without a plane there is no ground model: the sweep then says nothing
/// about what is free or occupied, and the cost map stays as it was.
struct GroundReport {
  std::optional<GroundPlane> plane;  ///< In the map frame.
  double sensor_height_m = 0.0;      ///< Of the sensor above the plane, where there is one.
  double surface_area_m2 = 0.0;      ///< Of the floor that the robot reaches, as far as it was seen.
  std::string note;                  ///< One sentence for people.
};

struct MapChange {
  GroundReport ground;
  std::vector<Cell> changed_tiles;  ///< Of the cost map, in order; tiles that went away included.
  std::uint64_t version = 0;        ///< The closed version of the cost map that this change made.
};

/// Every product of the mapper, from sweeps at given poses.
class Map {
 public:
  Map(const Robot& robot, std::uint64_t seed);

  /// Where the first sweep of a map belongs: level by its tracker (or as it is, without one), its x axis ahead, and
  /// z = 0 at the ground below its sensor's foot. Where no ground is found: at the sensor's height, if that is known.
  Pose first_pose(const Sweep& sweep) const;

  /// Adds a sweep to every product.
  MapChange merge(const Sweep& sweep, const Pose& X_map_sweep, StageListener* stages = nullptr);

  /// Takes the place of `before`, of which it is another making: `change` becomes all that differs between the two, and
  /// closes the next version.
  void succeed(const Map& before, MapChange& change);

  /// What stands here is the first version of a map that goes on.
  void restart_versions() { version_ = 1; }

  const VoxelCloud& cloud() const { return cloud_; }
  const OccupancyTree& occupancy_tree() const { return tree_; }
  const CostMap& cost_map() const { return cost_map_; }
  std::uint64_t version() const { return version_; }

 private:
  GroundReport find_ground(const MapPoints& points, const Sweep& sweep) const;

  /// What a sweep made of the cost map's states, and in which tiles.
  struct Projection {
    GroundReport ground;
    std::vector<Cell> changed_tiles;
  };
  Projection project(const MapPoints& points, const Sweep& sweep, const Pose& X_map_sweep, StageListener* stages);
  Projection project_by_paper(const MapPoints& points, StageListener* stages);
  Projection project_by_evidence(const MapPoints& points, const Sweep& sweep, const Pose& X_map_sweep,
                                 StageListener* stages);

  Robot robot_;
  std::uint64_t seed_;
  VoxelCloud cloud_;
  OccupancyTree tree_;
  EvidenceHistory evidence_;  ///< By how many sweeps came before; of the default projection.
  CostMap cost_map_;
  std::vector<Eigen::Vector3d> origins_;
  std::uint64_t version_ = 0;
};

}  // namespace scanway
