#include "modules/link/node/cloud_level.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <map>

namespace scanway {
namespace {

struct Mean {
  double x = 0.0, y = 0.0, z = 0.0, intensity = 0.0;
  double count = 0.0;
};

std::int64_t voxel_of(float coordinate, double voxel_m) {
  return static_cast<std::int64_t>(std::floor(static_cast<double>(coordinate) / voxel_m));
}

}  // namespace

cloud_tile_t coarsened(const cloud_tile_t& tile, double voxel_m) {
  std::map<std::array<std::int64_t, 3>, Mean> voxels;
  const bool has_intensity = !tile.intensity.empty();
  for (std::size_t i = 0; i < tile.x.size(); ++i) {
    Mean& mean = voxels[{voxel_of(tile.x[i], voxel_m), voxel_of(tile.y[i], voxel_m), voxel_of(tile.z[i], voxel_m)}];
    mean.x += static_cast<double>(tile.x[i]);
    mean.y += static_cast<double>(tile.y[i]);
    mean.z += static_cast<double>(tile.z[i]);
    if (has_intensity) mean.intensity += static_cast<double>(tile.intensity[i]);
    mean.count += 1.0;
  }
  cloud_tile_t coarse = tile;
  coarse.voxel_m = voxel_m;
  for (auto* column : {&coarse.x, &coarse.y, &coarse.z, &coarse.intensity}) column->clear();
  for (const auto& [voxel, mean] : voxels) {
    coarse.x.push_back(static_cast<float>(mean.x / mean.count));
    coarse.y.push_back(static_cast<float>(mean.y / mean.count));
    coarse.z.push_back(static_cast<float>(mean.z / mean.count));
    if (has_intensity) coarse.intensity.push_back(static_cast<float>(mean.intensity / mean.count));
  }
  coarse.npoints = static_cast<std::int32_t>(coarse.x.size());
  coarse.nintensities = static_cast<std::int32_t>(coarse.intensity.size());
  return coarse;
}

}  // namespace scanway
