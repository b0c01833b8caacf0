#include "modules/mapper/core/octomap/ray_lanes.h"

#include <algorithm>

namespace scanway {
namespace {

constexpr std::size_t kLanes = RayLanes::kLanes;
using State = RayLanes::State;
using Doubles = RayLanes::Doubles;
using Words = RayLanes::Words;

// OctoMap has room for so many voxels along a ray; a longer one has no defined result there.
constexpr std::int64_t kMostVoxels = 100'000;
constexpr std::int64_t kStepsAtOnce = 16;  // so many voxels of each lane stay in the nearest cache

namespace any_cpu {
#include "modules/mapper/core/octomap/lane_steps.inc"
}
#pragma GCC push_options
#pragma GCC target("avx2")
namespace avx2 {
#include "modules/mapper/core/octomap/lane_steps.inc"
}
#pragma GCC pop_options
#pragma GCC push_options
#pragma GCC target("avx512f")
namespace avx512 {
#include "modules/mapper/core/octomap/lane_steps.inc"
}
#pragma GCC pop_options

std::vector<RayLanes::Variant> variants_of_this_cpu() {
  std::vector<RayLanes::Variant> variants;
  if (__builtin_cpu_supports("avx512f")) variants.push_back({"avx512f", avx512::step_all});
  if (__builtin_cpu_supports("avx2")) variants.push_back({"avx2", avx2::step_all});
  variants.push_back({"any", any_cpu::step_all});
  return variants;
}

}  // namespace

const std::vector<RayLanes::Variant>& RayLanes::variants() {
  static const std::vector<Variant> variants = variants_of_this_cpu();
  return variants;
}

RayLanes::RayLanes(VoxelBricks& bricks) : RayLanes(bricks, variants().front()) {}

void RayLanes::add(const KeyRay& ray) {
  if (used_ == kLanes) walk_until_one_is_done();
  load(used_++, ray);
  if (ray.sure_steps <= 0) walk_to_end(--used_);
}

void RayLanes::finish() {
  while (used_ > 0) walk_to_end(--used_);
}

void RayLanes::load(std::size_t lane, const KeyRay& ray) {
  for (int axis = 0; axis < 3; ++axis) {
    state_.border_m[axis][lane] = ray.border_m[axis];
    state_.between_m[axis][lane] = ray.between_m[axis];
  }
  state_.code[lane] = ray.code;
  state_.mirror[lane] = ray.mirror;
  const std::int64_t sure = std::max<std::int64_t>(0, ray.sure_steps);
  ends_[lane] = {ray.end, ray.length_m, sure, 1 + sure};
}

void RayLanes::move(std::size_t from, std::size_t to) {
  for (int axis = 0; axis < 3; ++axis) {
    state_.border_m[axis][to] = state_.border_m[axis][from];
    state_.between_m[axis][to] = state_.between_m[axis][from];
  }
  state_.code[to] = state_.code[from];
  state_.mirror[to] = state_.mirror[from];
  places_[to] = places_[from];
  ends_[to] = ends_[from];
}

inline void RayLanes::mark(Place& place, MortonCode voxel) {
  const VoxelBricks::BrickNumber brick = voxel >> kBrickBits, number = brick >> VoxelBricks::kTableBits;
  if (place.number != number) place = {number, &bricks_.table_of(brick)};
  bricks_.at(*place.table, brick).free[voxel / 64 % kBrickWords] |= std::uint64_t{1} << (voxel % 64);
}

void RayLanes::walk(std::int64_t steps) {
  Words voxels[kStepsAtOnce];
  while (steps > 0) {
    const std::int64_t now = std::min(steps, kStepsAtOnce);
    step_all_(state_, static_cast<std::size_t>(now), voxels);
    // Step by step, not ray by ray: voxels of one ray share words, and each would wait for the one before.
    for (std::int64_t s = 0; s < now; ++s) {
      for (std::size_t lane = 0; lane < kLanes; ++lane) mark(places_[lane], voxels[s][lane]);
    }
    steps -= now;
  }
}

void RayLanes::walk_until_one_is_done() {
  std::int64_t steps = ends_[0].sure_steps;
  for (const End& end : ends_) steps = std::min(steps, end.sure_steps);
  walk(steps);
  for (End& end : ends_) end.sure_steps -= steps;
  for (std::size_t lane = kLanes; lane-- > 0;) {
    if (ends_[lane].sure_steps > 0) continue;
    walk_to_end(lane);
    move(--used_, lane);
  }
}

void RayLanes::walk_to_end(std::size_t lane) {
  double t[3] = {state_.border_m[0][lane], state_.border_m[1][lane], state_.border_m[2][lane]};
  MortonCode code = state_.code[lane];
  const End& end = ends_[lane];
  for (std::int64_t n = end.voxels - end.sure_steps; n < kMostVoxels; ++n) {
    const std::size_t axis = t[0] < t[1] ? (t[0] < t[2] ? 0 : 2) : (t[1] < t[2] ? 1 : 2);
    t[axis] += state_.between_m[axis][lane];
    const MortonCode bits = kAxisBits[axis];
    code = (((code & bits) - bits) & bits) | (code & ~bits);
    if (code == end.code || std::min(std::min(t[0], t[1]), t[2]) > end.length_m) return;
    mark(places_[lane], code ^ state_.mirror[lane]);
  }
}

}  // namespace scanway
