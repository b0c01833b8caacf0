#include "modules/mapper/core/cloud/voxel_sums.h"

#include <algorithm>
#include <cmath>

#include "modules/mapper/core/cloud/radix_sort.h"
#include "modules/mapper/core/cloud/voxel_place.h"

namespace scanway {
namespace {

constexpr double kIntensityUnit = 256.0;
constexpr double kIntensityLimit = 1e9;  // so that 2^24 points cannot overflow a sum

/// std::floor, for numbers that an int64 holds, without a call where the CPU need not have an instruction for it.
std::int64_t floor_of(double v) {
  const auto truncated = static_cast<std::int64_t>(v);
  return truncated - (static_cast<double>(truncated) > v ? 1 : 0);
}

std::int64_t fixed_intensity(float intensity) {
  if (!std::isfinite(intensity)) return 0;
  const double clamped = std::clamp(static_cast<double>(intensity), -kIntensityLimit, kIntensityLimit);
  return floor_of(clamped * kIntensityUnit + 0.5);
}

/// A point on its way to its voxel.
struct Entry {
  std::uint64_t key;
  std::uint32_t offset;  ///< Three times kFractionBits.
  std::uint32_t index;
};

/// False for a point out of the extent, or not finite.
bool find_voxel(const Eigen::Vector3f& point, double scale, Entry& entry) {
  for (int k = 0; k < 3; ++k) {
    const double fixed = static_cast<double>(point[k]) * scale + 0.5;
    if (!(std::fabs(fixed) < static_cast<double>(kHalfExtent * kFractions))) return false;
    const auto units = static_cast<std::uint64_t>(floor_of(fixed) + kHalfExtent * kFractions);
    entry.key |= spread_bits(units >> kFractionBits) << k;
    entry.offset |= static_cast<std::uint32_t>(units & (kFractions - 1)) << (kFractionBits * k);
  }
  return true;
}

template <class Keyed>
std::size_t count_keys(const std::vector<Keyed>& sorted) {
  std::size_t count = sorted.empty() ? 0 : 1;
  for (std::size_t i = 1; i < sorted.size(); ++i) count += sorted[i].key != sorted[i - 1].key ? 1 : 0;
  return count;
}

std::vector<Entry> sorted_entries(const MapPoints& points, double voxel_m) {
  std::vector<Entry> entries;
  entries.reserve(points.points.size());
  const double scale = static_cast<double>(kFractions) / voxel_m;
  for (std::size_t i = 0; i < points.points.size(); ++i) {
    Entry entry{0, 0, static_cast<std::uint32_t>(i)};
    if (find_voxel(points.points[i], scale, entry)) entries.push_back(entry);
  }
  radix_sort_by_key(entries);
  return entries;
}

Eigen::Vector3f centroid(const VoxelSum& voxel, double unit) {
  Eigen::Vector3f point;
  for (int k = 0; k < 3; ++k) {
    const auto index = static_cast<std::int64_t>(gather_bits(voxel.key >> k)) - kHalfExtent;
    const double mean = static_cast<double>(voxel.offset_sum[static_cast<std::size_t>(k)]) / voxel.count;
    point[k] = static_cast<float>((static_cast<double>(index * kFractions) + mean) * unit);
  }
  return point;
}

}  // namespace

std::vector<VoxelSum> voxel_sums(const MapPoints& points, double voxel_m) {
  const std::vector<Entry> entries = sorted_entries(points, voxel_m);
  std::vector<VoxelSum> voxels;
  voxels.reserve(count_keys(entries));
  for (const Entry& entry : entries) {
    if (voxels.empty() || voxels.back().key != entry.key) voxels.push_back({.key = entry.key});
    VoxelSum& voxel = voxels.back();
    ++voxel.count;
    for (std::size_t k = 0; k < 3; ++k) voxel.offset_sum[k] += (entry.offset >> (kFractionBits * k)) & (kFractions - 1);
    if (points.intensity.empty()) continue;
    ++voxel.with_intensity;
    voxel.intensity_sum += fixed_intensity(points.intensity[entry.index]);
  }
  return voxels;
}

void add_up(std::vector<VoxelSum>& sums) {
  const auto by_key = [](const VoxelSum& a, const VoxelSum& b) { return a.key < b.key; };
  if (sums.empty()) return;
  if (!std::is_sorted(sums.begin(), sums.end(), by_key)) radix_sort_by_key(sums);
  std::size_t last = 0;
  for (std::size_t i = 1; i < sums.size(); ++i) {
    if (sums[i].key != sums[last].key) {
      sums[++last] = sums[i];
      continue;
    }
    VoxelSum& voxel = sums[last];
    voxel.count += sums[i].count;
    voxel.with_intensity += sums[i].with_intensity;
    for (std::size_t k = 0; k < 3; ++k) voxel.offset_sum[k] += sums[i].offset_sum[k];
    voxel.intensity_sum += sums[i].intensity_sum;
    for (std::size_t k = 0; k < 3; ++k) voxel.normal_sum[k] += sums[i].normal_sum[k];
  }
  sums.resize(last + 1);
}

std::size_t count_points(const std::vector<VoxelSum>& sums) {
  std::size_t count = 0;
  for (const VoxelSum& voxel : sums) count += voxel.count;
  return count;
}

Eigen::Vector3f mean_normal(const VoxelSum& voxel) {
  const Eigen::Vector3d sum(voxel.normal_sum[0], voxel.normal_sum[1], voxel.normal_sum[2]);
  const double length = sum.norm();
  return length > 0.0 ? Eigen::Vector3f((sum / length).cast<float>()) : Eigen::Vector3f::Zero();
}

void append_centroids(const std::vector<VoxelSum>& sums, double voxel_m, bool with_intensity, PointCloud& cloud) {
  const double unit = voxel_m / static_cast<double>(kFractions);
  for (const VoxelSum& voxel : sums) {
    cloud.points.push_back(centroid(voxel, unit));
    cloud.normals.push_back(mean_normal(voxel));
    if (!with_intensity) continue;
    const double sum = static_cast<double>(voxel.intensity_sum) / kIntensityUnit;
    cloud.intensity.push_back(voxel.with_intensity == 0 ? 0.0f : static_cast<float>(sum / voxel.with_intensity));
  }
}

}  // namespace scanway
