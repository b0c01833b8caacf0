#include "modules/mapper/core/cloud/packed_sweep.h"

#include <algorithm>
#include <span>

#include <tbb/enumerable_thread_specific.h>

#include "common/parallel/blocks.h"
#include "modules/mapper/core/cloud/cube_runs.h"
#include "modules/mapper/core/cloud/cube_sums.h"
#include "modules/mapper/core/cloud/packed_sums.h"
#include "modules/mapper/core/cloud/surface_normals.h"
#include "modules/mapper/core/cloud/voxel_place.h"

namespace scanway {
namespace {

using Runs = std::span<const CubeRun>;

/// Those at the beginning whose keys are alike but for their last bits.
Runs alike(Runs runs, int bits) {
  const std::uint64_t key = runs.front().key >> bits;
  const auto end = std::find_if(runs.begin(), runs.end(), [&](const CubeRun& run) { return run.key >> bits != key; });
  return runs.first(static_cast<std::size_t>(end - runs.begin()));
}

std::vector<Runs> runs_of_tiles(Runs runs) {
  std::vector<Runs> tiles;
  for (; !runs.empty(); runs = runs.subspan(tiles.back().size())) {
    tiles.push_back(alike(runs, kTileBits - kCubeBits));
  }
  return tiles;
}

/// What one thread needs to work on one tile after the other.
class TilePacker {
 public:
  TilePacker(const MapPoints& points, double voxel_m)
      : sums_(points, voxel_m), normals_(points.origin, voxel_m), with_intensity_(!points.intensity.empty()) {}

  PackedTile pack(Runs runs) {
    PackedTile tile{runs.front().key >> (kTileBits - kCubeBits), {}};
    SumPacker packer(tile.number << kTileBits, with_intensity_);
    while (!runs.empty()) {
      const Runs of_cube = alike(runs, 0);
      std::vector<VoxelSum>& voxels = sums_.add_up(of_cube);
      normals_.set(voxels);
      packer.pack(voxels, tile.sums);
      tile.voxels += voxels.size();
      for (const VoxelSum& voxel : voxels) tile.points += voxel.count;
      runs = runs.subspan(of_cube.size());
    }
    return tile;
  }

 private:
  CubeSums sums_;
  SurfaceNormals normals_;
  bool with_intensity_;
};

}  // namespace

std::vector<PackedTile> packed_sweep(const MapPoints& points, double voxel_m) {
  const std::vector<CubeRun> runs = cube_runs(points.points, voxel_m);
  const std::vector<Runs> of_tiles = runs_of_tiles(runs);
  std::vector<PackedTile> tiles(of_tiles.size());
  tbb::enumerable_thread_specific<TilePacker> of_thread([&] { return TilePacker(points, voxel_m); });
  for_blocks(of_tiles.size(), 1,
             [&](std::size_t tile, std::size_t, std::size_t) { tiles[tile] = of_thread.local().pack(of_tiles[tile]); });
  return tiles;
}

}  // namespace scanway
