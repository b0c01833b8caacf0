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
  bool is_in_cube_of(const FixedPlace& other) const {
    return ((x ^ other.x) | (y ^ other.y) | (z ^ other.z)) >> kInCubeBits == 0;
  }

  static constexpr int kInCubeBits = 7 + 10;                         ///< Those that the places in one cube differ in.
  static constexpr std::uint32_t kOutside = std::uint32_t{1} << 31;  ///< In a coordinate that is.
};

/// The lowest corner of the cube of that number (voxel_place.h).
FixedPlace place_of_cube(std::uint64_t cube);

/// Where `points` lie, 1024 / voxel_m to the metre, each at the nearest 1024th. As many places as points.
void fix_places(std::span<const Eigen::Vector3f> points, double voxel_m, std::vector<FixedPlace>& places);

}  // namespace scanway
