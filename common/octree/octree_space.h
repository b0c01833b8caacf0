#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "common/octree/octree_file.h"

namespace scanway::octree {

constexpr int kDepth = 16;
constexpr std::int32_t kCentre = 1 << (kDepth - 1);  ///< The voxel at the map's origin.
constexpr OctreeLeaf kWhole{{-kCentre, -kCentre, -kCentre}, 1 << kDepth, false};

constexpr std::string_view kBinary = "# Octomap OcTree binary file", kFull = "# Octomap OcTree file";

/// One of the eight parts of a cube.
inline OctreeLeaf part_of(const OctreeLeaf& cube, int child) {
  OctreeLeaf part{cube.low, cube.side / 2, false};
  for (int axis = 0; axis < 3; ++axis) part.low[static_cast<std::size_t>(axis)] += (child >> axis & 1) * part.side;
  return part;
}

}  // namespace scanway::octree
