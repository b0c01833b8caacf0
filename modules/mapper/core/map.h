#pragma once

#include <cstdint>
#include <map>
#include <memory>
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
#include "modules/mapper/core/costmap/look.h"
#include "modules/mapper/core/octomap/occupancy_tree.h"
#include "modules/mapper/core/storage/byte_store.h"
#include "modules/mapper/core/sweep_archive.h"

namespace scanway {

struct MapChange {
  GroundReport ground;
  std::vector<Cell> changed_tiles;                    ///< Of the cost map, in order; tiles that went away included.
  std::vector<VoxelCloud::TileNumber> changed_cloud;  ///< Tiles of the cloud, in order; emptied ones included.
  std::uint64_t version = 0;                          ///< The closed version of the cost map that this change made.
};

/// Where a sweep of the map belongs from now on.
struct SweepMove {
  SweepNumber sweep = 0;
  Pose X_map_sweep = Pose::Identity();
};

/// Where a map keeps what it needs of its sweeps only to be revised. (A disk, for long missions.)
struct MapStorage {
  std::unique_ptr<SweepArchive> sweeps = std::make_unique<SweepsInMemory>();
  std::shared_ptr<ByteStore> bytes = std::make_shared<BytesInMemory>();
};

/// Every product of the mapper, from sweeps at given poses. Sweeps are numbered from 0 as they come; where two saw the
/// same place, the one with the greater number has its say, whenever the other was moved. Whatever is done here, the
/// products are to the byte those of a map that was made at once of the sweeps that are left, at their last poses.
class Map {
 public:
  Map(const Robot& robot, std::uint64_t seed, MapStorage storage = {});

  /// Where the first sweep of a map belongs: level by its tracker (or as it is, without one), its x axis ahead, and
  /// z = 0 at the ground below its sensor's foot. Where no ground is found: at the sensor's height, if that is known.
  Pose first_pose(const Sweep& sweep) const;

  /// Adds a sweep to every product, after `moves` of those before it.
  MapChange merge(const Sweep& sweep, const Pose& X_map_sweep, StageListener* stages = nullptr,
                  const std::vector<SweepMove>& moves = {});
  /// Puts sweeps at other poses (any that was withdrawn is back then). Throws std::logic_error when there is no such
  /// sweep, as withdraw() does.
  MapChange move(const std::vector<SweepMove>& moves, StageListener* stages = nullptr);
  /// Takes a sweep out of every product.
  MapChange withdraw(SweepNumber sweep, StageListener* stages = nullptr);

  /// What stands here is the first version of a map that goes on.
  void restart_versions() { version_ = 1; }

  const VoxelCloud& cloud() const { return cloud_; }
  const OccupancyTree& occupancy_tree() const { return tree_; }
  const CostMap& cost_map() const { return cost_map_; }
  std::uint64_t version() const { return version_; }
  bool holds(SweepNumber sweep) const { return origins_.contains(sweep); }

 private:
  MapPoints points_of(const Sweep& sweep, const Pose& X_map_sweep) const;

  /// What the cost map's states are made of, and in which tiles they changed.
  struct Projection {
    GroundReport ground;
    std::vector<Cell> changed_tiles;
  };
  Projection project_by_paper(StageListener* stages);

  /// To be settled: the tree, and the cost map's states.
  void put_again(const SweepMove& move);
  MapChange settle(StageListener* stages);
  MapChange close_version(Projection projection, StageListener* stages);

  Robot robot_;
  std::uint64_t seed_;
  MapStorage storage_;
  VoxelCloud cloud_;
  OccupancyTree tree_;
  EvidenceHistory evidence_;  ///< Of the default projection.
  CostMap cost_map_;
  std::map<SweepNumber, Eigen::Vector3d> origins_;  ///< Of the sweeps that are in the map.
  SweepNumber sweeps_ = 0;                          ///< That ever were.
  std::uint64_t version_ = 0;
};

}  // namespace scanway
