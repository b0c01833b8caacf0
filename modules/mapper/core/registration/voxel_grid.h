#pragma once

#include "modules/mapper/core/registration/points.h"

namespace scanway::registration {

/// The centroid of the points of every occupied voxel of edge `voxel_m`, in the order of the voxels (z, y, x), so that
/// neighbours in space are mostly neighbours in memory. Voxel (i, j, k) holds i <= x / voxel_m < i + 1. Exact as long
/// as every coordinate lies within 2^20 voxels of the origin; points beyond are left out.
Points voxel_centroids(const Points& points, float voxel_m);

}  // namespace scanway::registration
