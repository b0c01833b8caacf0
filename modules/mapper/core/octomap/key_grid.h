#pragma once

// OcTreeKey.h does not include what it needs.
#include <octomap/octomap_types.h>

#include <octomap/OcTreeKey.h>

namespace scanway {

/// Coordinates to keys and back with OctoMap's arithmetic (OcTreeBaseImpl), to the bit.
class KeyGrid {
 public:
  explicit KeyGrid(double resolution) : resolution_(resolution), factor_(1.0 / resolution) {}

  double resolution() const { return resolution_; }

  /// coordToKeyChecked: false outside of the tree's 65536 voxels a side, and for NaN.
  bool key_of(const octomap::point3d& point, octomap::OcTreeKey& key) const;
  /// coordToKey: a coordinate outside of the tree comes back in on the other side.
  octomap::OcTreeKey wrapped_key_of(const octomap::point3d& point) const;
  /// keyToCoord: the voxel's centre, in double along one axis and rounded to float as a point.
  double centre(octomap::key_type key) const;
  octomap::point3d centre(const octomap::OcTreeKey& key) const;

 private:
  int voxel_of(double coordinate) const;

  double resolution_;
  double factor_;
};

}  // namespace scanway
