#include "modules/mapper/core/octomap/ray_lanes.h"

#include <immintrin.h>

#include <algorithm>
#include <bit>
#include <cstring>

namespace scanway {
namespace {

constexpr std::size_t kLanes = RayLanes::kLanes;
using State = RayLanes::State;
using Doubles = RayLanes::Doubles;
using Words = RayLanes::Words;
using Passed = RayLanes::Passed;

// OctoMap has room for so many voxels along a ray; a longer one has no defined result there.
constexpr std::int64_t kMostVoxels = 100'000;

// Each with its way to make bits of a comparison.
namespace any_cpu {
inline std::uint8_t lanes_that_differ(const Words& a, const Words& b) {
  unsigned lanes = 0;
  for (std::size_t lane = 0; lane < kLanes; ++lane) lanes |= (a[lane] != b[lane] ? 1u : 0u) << lane;
  return static_cast<std::uint8_t>(lanes);
}
#include "modules/mapper/core/octomap/lane_steps.inc"
}  // namespace any_cpu
#pragma GCC push_options
#pragma GCC target("avx2")
namespace avx2 {
inline std::uint8_t lanes_that_differ(const Words& a, const Words& b) {
  const auto differ = a != b;
  __m256d halves[2];
  std::memcpy(halves, &differ, sizeof(halves));
  return static_cast<std::uint8_t>(_mm256_movemask_pd(halves[0]) | _mm256_movemask_pd(halves[1]) << 4);
}
#include "modules/mapper/core/octomap/lane_steps.inc"
}  // namespace avx2
#pragma GCC pop_options
#pragma GCC push_options
#pragma GCC target("avx512f")
namespace avx512 {
inline std::uint8_t lanes_that_differ(const Words& a, const Words& b) {
  __m512i both[2];
  std::memcpy(&both[0], &a, sizeof(both[0]));
  std::memcpy(&both[1], &b, sizeof(both[1]));
  return static_cast<std::uint8_t>(_mm512_cmpneq_epi64_mask(both[0], both[1]));
}
#include "modules/mapper/core/octomap/lane_steps.inc"
}  // namespace avx512
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
  state_.word[lane] = (ray.code ^ ray.mirror) / 64;
  state_.bits[lane] = 0;
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
  state_.word[to] = state_.word[from];
  state_.bits[to] = state_.bits[from];
  places_[to] = places_[from];
  ends_[to] = ends_[from];
}

inline std::uint64_t& RayLanes::word_of(std::size_t lane, std::uint64_t word) {
  const VoxelBricks::BrickNumber brick = word / kBrickWords, number = brick >> VoxelBricks::kTableBits;
  Place& place = places_[lane];
  if (place.number != number) place = {number, &bricks_.table_of(brick)};
  return bricks_.at(*place.table, brick).free[word % kBrickWords];
}

void RayLanes::walk(std::int64_t steps) {
  Passed passed;
  while (steps > 0) {
    const std::int64_t now = std::min<std::int64_t>(steps, kStepsAtOnce);
    std::memset(passed.left, 0, sizeof(passed.left));
    step_all_(state_, static_cast<std::size_t>(now), passed);
    mark(passed);
    steps -= now;
  }
}

/// Step by step, not ray by ray: neighbouring words share lines of the cache, and each would wait for the other.
void RayLanes::mark(const Passed& passed) {
  for (std::size_t first = 0; first < kStepsAtOnce; first += 8) {
    std::uint64_t left;  // of eight steps
    std::memcpy(&left, &passed.left[first], sizeof(left));
    for (; left != 0; left &= left - 1) {
      const auto i = static_cast<std::size_t>(std::countr_zero(left));
      const std::size_t step = first + i / kLanes, lane = i % kLanes;
      word_of(lane, passed.word[step][lane]) |= passed.bits[step][lane];
    }
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
  std::uint64_t word = state_.word[lane], bits = state_.bits[lane];
  const End& end = ends_[lane];
  for (std::int64_t n = end.voxels - end.sure_steps; n < kMostVoxels; ++n) {
    const std::size_t axis = t[0] < t[1] ? (t[0] < t[2] ? 0 : 2) : (t[1] < t[2] ? 1 : 2);
    t[axis] += state_.between_m[axis][lane];
    const MortonCode axis_bits = kAxisBits[axis];
    code = (((code & axis_bits) - axis_bits) & axis_bits) | (code & ~axis_bits);
    if (code == end.code || std::min(std::min(t[0], t[1]), t[2]) > end.length_m) break;
    const MortonCode voxel = code ^ state_.mirror[lane];
    if (voxel / 64 != word) {
      word_of(lane, word) |= bits;
      word = voxel / 64, bits = 0;
    }
    bits |= std::uint64_t{1} << (voxel % 64);
  }
  word_of(lane, word) |= bits;
}

}  // namespace scanway
