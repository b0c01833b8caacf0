#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "modules/mapper/core/cloud/map_points.h"
#include "modules/mapper/core/cloud/sweep_number.h"
#include "modules/mapper/core/octomap/voxel_history.h"
#include "modules/mapper/core/storage/byte_store.h"

namespace scanway {

class LogOddsTree;

struct OccupancyTreeConfig {
  double resolution_m = 0.1;
  double max_range_m = 20.0;  ///< Beams are cut off here; not above 0: they are not cut.
  bool discretize = true;     ///< One ray a voxel that is hit, instead of one a point.
  bool revisable = false;     ///< Keeps what each sweep says, packed, so that it can be withdrawn.
};

/// The OctoMap of the accepted sweeps: what liboctomap's OcTree with its default sensor model holds after
/// insertPointCloud(cloud, origin, max_range, lazy_eval = false, discretize) of each sweep in order. Who needs that
/// class reads it from ot_bytes(): octomap::AbstractOcTree::read.
class OccupancyTree {
 public:
  /// A revisable tree keeps in `store` what it needs to be revised.
  explicit OccupancyTree(const OccupancyTreeConfig& config,
                         std::shared_ptr<ByteStore> store = std::make_shared<BytesInMemory>());
  ~OccupancyTree();
  OccupancyTree(OccupancyTree&&) noexcept;
  OccupancyTree& operator=(OccupancyTree&&) noexcept;

  /// Points in the map frame; the origin is rounded to float, as OctoMap keeps it. Sweeps are numbered from 0.
  void insert(const MapPoints& points);

  /// Of a revisable tree: from the next settle() on it is what it would be without that sweep, or with other points in
  /// its place (at a pose that was corrected); one that was withdrawn can so be put back. Throw std::logic_error
  /// otherwise, or when there was no such sweep.
  void withdraw(SweepNumber sweep);
  void replace(SweepNumber sweep, const MapPoints& points);
  /// Makes anew the bricks (16 voxels a side) that these sweeps touched, from the voxels that are kept of every sweep.
  void settle();

  std::string ot_bytes() const;  ///< The .ot file: every node's log-odds.
  /// The same, some bytes after the other: of a large map they are too many to hold.
  void write_ot(const std::function<void(std::string_view)>& take) const;
  std::string bt_bytes() const;  ///< The .bt file: each node at its most likely state.

  struct Size {
    std::size_t nodes = 0, leaves = 0;
  };
  Size size() const;  ///< Counted anew.
  double resolution_m() const { return config_.resolution_m; }

 private:
  VoxelBricks voxels_of(const MapPoints& points) const;
  void touch(const BrickNumbers& numbers);

  OccupancyTreeConfig config_;
  std::unique_ptr<LogOddsTree> tree_;
  VoxelHistory history_;  ///< Of a revisable tree.
  BrickNumbers unsettled_;
  SweepNumber sweeps_ = 0;
};

}  // namespace scanway
