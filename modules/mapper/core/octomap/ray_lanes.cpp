#include "modules/mapper/core/octomap/ray_lanes.h"

#include <algorithm>
#include <cstring>

namespace scanway {
namespace {

constexpr std::size_t kLanes = RayLanes::kLanes;
using State = RayLanes::State;

// OctoMap has room for so many voxels along a ray; a longer one has no defined result there.
constexpr std::int64_t kMostVoxels = 100'000;

inline void mark(State& state, std::size_t lane, MortonCode mirrored, VoxelBricks& bricks) {
  const MortonCode code = mirrored ^ state.mirror[lane];
  if (code >> kBrickBits != state.brick[lane]) {
    state.brick[lane] = code >> kBrickBits;
    state.free[lane] = bricks.at(state.brick[lane]).free.data();
  }
  state.free[lane][code / 64 % kBrickWords] |= std::uint64_t{1} << (code % 64);
}

/// One step of every lane, without a branch; plain loops, so that the compiler makes of them what each CPU can.
inline void step_all(State& state) {
  double* const x = state.border_m[0];
  double* const y = state.border_m[1];
  double* const z = state.border_m[2];
#pragma GCC unroll 1
  for (std::size_t i = 0; i < kLanes; ++i) {
    const bool x_first = x[i] < y[i];
    const bool along_x = x_first & (x[i] < z[i]);
    const bool along_y = !x_first & (y[i] < z[i]);
    const bool along_z = !(along_x | along_y);
    x[i] += along_x ? state.between_m[0][i] : 0.0;
    y[i] += along_y ? state.between_m[1][i] : 0.0;
    z[i] += along_z ? state.between_m[2][i] : 0.0;
    const MortonCode bits = along_x ? kAxisBits[0] : along_y ? kAxisBits[1] : kAxisBits[2];
    const MortonCode code = state.code[i];
    state.code[i] = (((code | ~bits) + (bits & 7)) & bits) | (code & ~bits);
  }
}

__attribute__((target_clones("default", "avx2", "avx512f"))) void walk(State& state, std::int64_t steps,
                                                                       VoxelBricks& bricks) {
  for (std::int64_t s = 0; s < steps; ++s) {
    step_all(state);
    for (std::size_t lane = 0; lane < kLanes; ++lane) mark(state, lane, state.code[lane], bricks);
  }
}

}  // namespace

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
  state_.brick[lane] = (ray.code ^ ray.mirror) >> kBrickBits;
  state_.free[lane] = bricks_.at(state_.brick[lane]).free.data();
  state_.sure_steps[lane] = std::max<std::int64_t>(0, ray.sure_steps);
  state_.end[lane] = ray.end;
  state_.length_m[lane] = ray.length_m;
  state_.voxels[lane] = 1 + state_.sure_steps[lane];
}

void RayLanes::move(std::size_t from, std::size_t to) {
  for (int axis = 0; axis < 3; ++axis) {
    state_.border_m[axis][to] = state_.border_m[axis][from];
    state_.between_m[axis][to] = state_.between_m[axis][from];
  }
  state_.code[to] = state_.code[from];
  state_.mirror[to] = state_.mirror[from];
  state_.brick[to] = state_.brick[from];
  state_.free[to] = state_.free[from];
  state_.sure_steps[to] = state_.sure_steps[from];
  state_.end[to] = state_.end[from];
  state_.length_m[to] = state_.length_m[from];
  state_.voxels[to] = state_.voxels[from];
}

void RayLanes::walk_until_one_is_done() {
  const std::int64_t steps = *std::min_element(state_.sure_steps, state_.sure_steps + kLanes);
  walk(state_, steps, bricks_);
  for (std::int64_t& left : state_.sure_steps) left -= steps;
  for (std::size_t lane = kLanes; lane-- > 0;) {
    if (state_.sure_steps[lane] > 0) continue;
    walk_to_end(lane);
    move(--used_, lane);
  }
}

void RayLanes::walk_to_end(std::size_t lane) {
  double t[3] = {state_.border_m[0][lane], state_.border_m[1][lane], state_.border_m[2][lane]};
  MortonCode code = state_.code[lane];
  for (std::int64_t n = state_.voxels[lane] - state_.sure_steps[lane]; n < kMostVoxels; ++n) {
    const std::size_t axis = t[0] < t[1] ? (t[0] < t[2] ? 0 : 2) : (t[1] < t[2] ? 1 : 2);
    t[axis] += state_.between_m[axis][lane];
    const MortonCode bits = kAxisBits[axis];
    code = (((code | ~bits) + (MortonCode{1} << axis)) & bits) | (code & ~bits);
    if (code == state_.end[lane] || std::min(std::min(t[0], t[1]), t[2]) > state_.length_m[lane]) return;
    mark(state_, lane, code, bricks_);
  }
}

}  // namespace scanway
