#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "modules/mapper/core/cloud/map_points.h"

namespace scanway {

constexpr int kTileBits = 27;  ///< A tile is a cube of 512 voxels a side; its number is its voxels' key without these.

/// What one sweep shows of a tile: its voxels' sums with their normals, packed.
struct PackedTile {
  std::uint64_t number;
  std::vector<std::uint8_t> sums;
  std::size_t voxels = 0, points = 0;
};

/// The tiles of a sweep, in order. Points that are not finite or further than 2^20 voxels from the origin are left out.
std::vector<PackedTile> packed_sweep(const MapPoints& points, double voxel_m);

}  // namespace scanway
