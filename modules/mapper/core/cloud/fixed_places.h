#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace scanway {

/// Coordinates in 1024ths of a voxel from the extent's lowest corner: 21 bits for the voxel, then 10 in it.
struct FixedPlace {
  std::uint32_t x, y, z;

  bool is_outside() const { return ((x | y | z) & kOutside) != 0; }  ///< Of the extent, or not finite.

  static constexpr std::uint32_t kOutside = std::uint32_t{1} << 31;  ///< In a coordinate that is.
};

/// Where `points` lie, 1024 / voxel_m to the metre, each at the nearest 1024th. As many places as points.
void fix_places(std::span<const Eigen::Vector3f> points, double voxel_m, std::vector<FixedPlace>& places);

}  // namespace scanway
