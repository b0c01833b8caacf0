#include "modules/mapper/core/cloud/cube_sums.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "modules/mapper/core/cloud/voxel_place.h"

namespace scanway {
namespace {

constexpr double kIntensityLimit = 1e9;  // so that 2^24 points cannot overflow a sum
constexpr std::size_t kDigits = 3;
constexpr std::uint32_t kDigitBits = kCubeBits / kDigits, kDigitValues = 1 << kDigitBits;

std::uint32_t digit_of(std::uint32_t voxel, std::size_t digit) {
  return voxel >> (kDigitBits * digit) & (kDigitValues - 1);
}

std::int64_t fixed_intensity(float intensity) {
  if (!std::isfinite(intensity)) return 0;
  const double clamped = std::clamp(static_cast<double>(intensity), -kIntensityLimit, kIntensityLimit);
  const double units = clamped * kIntensityUnit + 0.5;
  const auto truncated = static_cast<std::int64_t>(units);
  return truncated - (static_cast<double>(truncated) > units ? 1 : 0);
}

std::uint32_t offset_of(const FixedPlace& place) {
  constexpr std::uint32_t kMask = kFractions - 1;
  return (place.x & kMask) | (place.y & kMask) << kFractionBits | (place.z & kMask) << (2 * kFractionBits);
}

std::uint32_t voxel_of(const FixedPlace& place, const PlacesInCube& in_cube) {
  const auto along = [&in_cube](std::uint32_t fixed) {
    return in_cube.spread(fixed >> kFractionBits & ((1 << kCubeLevel) - 1));
  };
  return along(place.x) | along(place.y) << 1 | along(place.z) << 2;
}

}  // namespace

std::vector<VoxelSum>& CubeSums::add_up(std::span<const CubeRun> runs) {
  entries_.clear();
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (i + 1 < runs.size()) __builtin_prefetch(&points_.points[runs[i + 1].first]);
    take(runs[i]);
  }
  sort();
  add_up(runs.front().key << kCubeBits);
  return voxels_;
}

/// Points of other cubes are written over by those that follow.
void CubeSums::take(const CubeRun& run) {
  const PlacesInCube& in_cube = PlacesInCube::table();
  const FixedPlace cube = place_of_cube(run.key);
  const bool with_intensity = !points_.intensity.empty();
  fix_places(std::span(points_.points).subspan(run.first, run.count), voxel_m_, places_);
  std::size_t taken = entries_.size();
  entries_.resize(taken + run.count);
  for (std::size_t i = 0; i < run.count; ++i) {
    entries_[taken] = {voxel_of(places_[i], in_cube), offset_of(places_[i]),
                       with_intensity ? points_.intensity[run.first + i] : 0.0f};
    taken += places_[i].is_in_cube_of(cube) ? 1 : 0;
  }
  entries_.resize(taken);
}

/// By radix, least digit first.
void CubeSums::sort() {
  std::array<std::array<std::uint32_t, kDigitValues>, kDigits> begin{};
  for (const Entry& entry : entries_) {
    for (std::size_t d = 0; d < kDigits; ++d) ++begin[d][digit_of(entry.voxel, d)];
  }
  sorted_.resize(entries_.size());
  for (std::size_t d = 0; d < kDigits; ++d) {
    std::uint32_t total = 0;
    for (std::uint32_t& value : begin[d]) total += std::exchange(value, total);
    for (const Entry& entry : entries_) sorted_[begin[d][digit_of(entry.voxel, d)]++] = entry;
    entries_.swap(sorted_);
  }
}

/// Without a branch at the end of a voxel, which no CPU foresees.
void CubeSums::add_up(std::uint64_t first_key) {
  constexpr std::uint32_t kMask = kFractions - 1;
  const bool with_intensity = !points_.intensity.empty();
  voxels_.assign(entries_.size(), {});
  VoxelSum* voxel = voxels_.data();
  std::uint32_t place = entries_.empty() ? 0 : entries_.front().voxel;
  for (const Entry& entry : entries_) {
    voxel += entry.voxel != place ? 1 : 0;
    place = entry.voxel;
    voxel->key = first_key | place;
    ++voxel->count;
    for (std::size_t k = 0; k < 3; ++k) voxel->offset_sum[k] += entry.offset >> (kFractionBits * k) & kMask;
    if (!with_intensity) continue;
    ++voxel->with_intensity;
    voxel->intensity_sum += fixed_intensity(entry.intensity);
  }
  voxels_.resize(entries_.empty() ? 0 : static_cast<std::size_t>(voxel - voxels_.data()) + 1);
}

}  // namespace scanway
