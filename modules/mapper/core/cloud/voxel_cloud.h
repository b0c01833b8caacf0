#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <set>
#include <vector>

#include <Eigen/Geometry>

#include "common/cloud/point_cloud.h"
#include "modules/mapper/core/cloud/map_points.h"
#include "modules/mapper/core/cloud/sweep_number.h"
#include "modules/mapper/core/cloud/tile_sums.h"
#include "modules/mapper/core/storage/byte_store.h"

namespace scanway {

/// The registered cloud: one point a voxel, the centroid of all points that fell into it.
///
/// Coordinates are counted in 1024ths of a voxel and summed in integers, so the cloud is the same whatever the order in
/// which points or sweeps arrive. A centroid is off by at most 1/2048 of a voxel (5 um at 1 cm) a coordinate.
/// Its normal is the sum of those that each sweep's own points show (surface_normals.h), in integers too.
/// Any extent to +-2^20 voxels from the map's origin (10 km at 1 cm); points beyond are left out and counted.
///
/// What each sweep shows is kept for itself, packed, by tile, in a store; a voxel is added up when it is asked for. So
/// a sweep comes, moves and goes at its own cost, whatever the size of the map, and the memory holds a tile at a time.
class VoxelCloud {
 public:
  explicit VoxelCloud(double voxel_m, std::shared_ptr<ByteStore> store = std::make_shared<BytesInMemory>());

  /// What the sweep shows from now on: points in the map frame, of which those that are not finite are left out.
  void put(SweepNumber sweep, const MapPoints& points);
  /// The cloud is then the one that never had the sweep. Throws std::invalid_argument when there is no such sweep.
  void withdraw(SweepNumber sweep);

  /// A cube of 512 voxels a side, by its place in the order of their Morton codes.
  using TileNumber = std::uint64_t;
  std::vector<TileNumber> tiles() const;  ///< Those with points, in order.
  /// Those that sweeps came to, or left, since this was asked last, in order.
  std::vector<TileNumber> take_changed_tiles();
  Eigen::AlignedBox3d box_of(TileNumber tile) const;  ///< Metres, in the map frame.

  /// Centroids in Morton order of their voxels, in the map frame, with their normals and the mean intensity (when
  /// points had any): of one tile (intensity: when a sweep with points there had any), or of all of the sweeps before
  /// number `end`.
  PointCloud centroids_of(TileNumber tile) const;
  PointCloud centroids(SweepNumber end = std::numeric_limits<SweepNumber>::max()) const;

  double voxel_m() const { return voxel_m_; }
  std::size_t size() const;  ///< Voxels that hold a point; counted anew.
  std::uint64_t points_out_of_extent() const;

 private:
  /// What one sweep shows.
  struct View {
    std::map<TileNumber, std::size_t> begin;  ///< Where each tile's sums begin, and at last where all end.
    StoredBytes sums;
    std::size_t voxels = 0;
    bool with_intensity = false;
    std::uint64_t points_out_of_extent = 0;
  };

  TileSums sums_of(TileNumber tile, SweepNumber end = std::numeric_limits<SweepNumber>::max()) const;
  void note_change(const View& view);
  void forget(std::map<SweepNumber, View>::iterator view);

  double voxel_m_;
  std::shared_ptr<ByteStore> store_;
  std::map<SweepNumber, View> views_;
  std::set<TileNumber> changed_;
};

}  // namespace scanway
