#pragma once

#include <cstddef>
#include <cstdint>

#include "modules/mapper/core/octomap/key_ray.h"
#include "modules/mapper/core/octomap/voxel_bricks.h"

namespace scanway {

/// Marks the voxels along rays as free, eight rays abreast.
class RayLanes {
 public:
  static constexpr std::size_t kLanes = 8;

  explicit RayLanes(VoxelBricks& bricks) : bricks_(bricks) {}

  /// The whole ray but its first voxel; it may be under way until finish().
  void add(const KeyRay& ray);
  void finish();

  /// What the lanes step, a row each quantity.
  struct State {
    alignas(64) double border_m[3][kLanes];
    alignas(64) double between_m[3][kLanes];
    alignas(64) MortonCode code[kLanes];
    alignas(64) MortonCode mirror[kLanes];
    VoxelBricks::BrickNumber brick[kLanes];  ///< The brick of `free`.
    std::uint64_t* free[kLanes];
    std::int64_t sure_steps[kLanes];  ///< That are still to go.
    MortonCode end[kLanes];
    double length_m[kLanes];
    std::int64_t voxels[kLanes];  ///< Marked when the sure steps are done.
  };

 private:
  void load(std::size_t lane, const KeyRay& ray);
  void move(std::size_t from, std::size_t to);
  void walk_until_one_is_done();
  void walk_to_end(std::size_t lane);

  State state_{};
  std::size_t used_ = 0;
  VoxelBricks& bricks_;
};

}  // namespace scanway
