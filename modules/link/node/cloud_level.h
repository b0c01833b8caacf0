#pragma once

#include "scanway/cloud_tile_t.hpp"

namespace scanway {

/// A cube of the cloud in less detail: of the points in each voxel of that side their mean, in ascending order of the
/// voxels' x, then y, then z. Cubes whose side is a multiple of the voxel's give what the whole cloud would.
cloud_tile_t coarsened(const cloud_tile_t& tile, double voxel_m);

}  // namespace scanway
