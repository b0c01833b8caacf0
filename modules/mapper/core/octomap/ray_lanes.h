#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "modules/mapper/core/octomap/key_ray.h"
#include "modules/mapper/core/octomap/voxel_bricks.h"

namespace scanway {

/// Marks the voxels along rays as free, eight rays abreast.
class RayLanes {
 public:
  static constexpr std::size_t kLanes = 8;

  /// Steps as the fastest variant does.
  explicit RayLanes(VoxelBricks& bricks);

  /// The whole ray but its first voxel, whose brick is made if it is not there; it may be under way until finish().
  void add(const KeyRay& ray);
  void finish();

  using Doubles = double __attribute__((vector_size(8 * kLanes)));
  using Words = std::uint64_t __attribute__((vector_size(8 * kLanes)));

  /// What the lanes step, one vector each quantity.
  struct State {
    Doubles border_m[3];
    Doubles between_m[3];
    Words code;
    Words mirror;
    Words word;  ///< The number of the 64 voxels (VoxelBrick's words) that it is in,
    Words bits;  ///< and those of them that it passed since it came there.
  };

  static constexpr std::size_t kStepsAtOnce = 16;  ///< So many steps' voxels stay in the nearest cache.
  /// Where the lanes were before each step, and by bits which lanes then left that word: some four voxels of a ray are
  /// in one, and are marked at once.
  struct Passed {
    Words word[kStepsAtOnce];
    Words bits[kStepsAtOnce];
    std::uint8_t left[kStepsAtOnce];
  };

  /// The steps as they are compiled for one kind of CPU. All give the same bits.
  struct Variant {
    std::string_view cpu;
    /// So many steps of all lanes, kStepsAtOnce at most.
    void (*step_all)(State& state, std::size_t steps, Passed& passed);
  };
  /// Those that this CPU can run, the fastest first.
  static const std::vector<Variant>& variants();
  RayLanes(VoxelBricks& bricks, const Variant& variant) : bricks_(bricks), step_all_(variant.step_all) {}

 private:
  /// A ray's part of the bricks that it is in, so that not every voxel is looked for from the top.
  struct Place {
    VoxelBricks::BrickNumber number = ~VoxelBricks::BrickNumber{0};  ///< Of the table.
    VoxelBricks::Table* table = nullptr;
  };
  /// What ends a ray.
  struct End {
    MortonCode code;
    double length_m;
    std::int64_t sure_steps;  ///< That are still to go.
    std::int64_t voxels;      ///< Marked when the sure steps are done.
  };
  std::uint64_t& word_of(std::size_t lane, std::uint64_t word);
  void mark(const Passed& passed);
  void load(std::size_t lane, const KeyRay& ray);
  void move(std::size_t from, std::size_t to);
  void walk(std::int64_t steps);
  void walk_until_one_is_done();
  void walk_to_end(std::size_t lane);

  State state_{};
  std::array<Place, kLanes> places_;
  std::array<End, kLanes> ends_;
  std::size_t used_ = 0;
  VoxelBricks& bricks_;
  void (*step_all_)(State& state, std::size_t steps, Passed& passed);
};

}  // namespace scanway
