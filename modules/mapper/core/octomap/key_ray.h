#pragma once

#include <array>
#include <cstdint>

#include "modules/mapper/core/octomap/key_grid.h"
#include "modules/mapper/core/octomap/voxel_bricks.h"

namespace scanway {

/// A ray on its way through the voxels as OcTreeBaseImpl::computeRayKeys steps it, with the same double and float
/// operations in the same order. Axes along which it goes down are mirrored, so that every step is one up.
struct KeyRay {
  std::array<double, 3> border_m;   ///< Along the ray, to the next border across each axis.
  std::array<double, 3> between_m;  ///< Along the ray, from border to border.
  MortonCode code;                  ///< Of the voxel that it is in, mirrored.
  MortonCode end;                   ///< Of the voxel of its end point, mirrored.
  MortonCode mirror;                ///< code ^ mirror is the voxel's code.
  double length_m;
  /// As many steps certainly lead neither to the end voxel nor past the end point: each step nears the end voxel by one
  /// key, and rounding shifts a border by far less than a voxel.
  std::int64_t sure_steps;
};

/// Rays from one sensor position.
class KeyRays {
 public:
  /// Outside of the tree there are no rays at all.
  KeyRays(const KeyGrid& grid, const octomap::point3d& origin);

  /// False when the ray is nothing: an end is outside of the tree, or both are in one voxel.
  bool start(const octomap::point3d& end, KeyRay& ray) const;
  MortonCode origin_code() const { return origin_code_; }

 private:
  KeyGrid grid_;
  octomap::point3d origin_;
  bool origin_inside_;
  octomap::OcTreeKey origin_key_;
  MortonCode origin_code_ = 0;
  std::array<std::array<double, 2>, 3> to_border_;  ///< Of each axis, down and up.
};

}  // namespace scanway
