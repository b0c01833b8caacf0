#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace scanway {

/// Points that follow each other in a sweep and lie in one cube of 128 voxels a side (voxel_place.h). A laser's do so
/// for long: to sort runs by their cubes is much less work than to sort the points.
struct CubeRun {
  std::uint64_t key;  ///< The cube's: that of its voxels without the last 21 bits.
  std::uint32_t first, count;
};

/// Those of all points that are finite and not further than 2^20 voxels from the origin, by cube.
std::vector<CubeRun> cube_runs(std::span<const Eigen::Vector3f> points, double voxel_m);

}  // namespace scanway
