#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace scanway {

/// A part of a sweep's points in which those of one cube of 128 voxels a side (voxel_place.h) follow each other, maybe
/// with others between: where a surface lies on the border of two cubes, their runs go side by side. A laser's runs are
/// long: to sort them by their cubes is much less work than to sort the points.
struct CubeRun {
  std::uint64_t key;  ///< The cube's: that of its voxels without the last 21 bits.
  std::uint32_t first, count;
};

/// By cube: each point that is finite and not further than 2^20 voxels from the origin is in one run of its cube.
std::vector<CubeRun> cube_runs(std::span<const Eigen::Vector3f> points, double voxel_m);

}  // namespace scanway
