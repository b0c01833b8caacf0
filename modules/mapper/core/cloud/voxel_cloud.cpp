#include "modules/mapper/core/cloud/voxel_cloud.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "modules/mapper/core/cloud/radix_sort.h"

namespace scanway {
namespace {

constexpr int kFractionBits = 10;
constexpr std::int64_t kFractions = std::int64_t{1} << kFractionBits;
constexpr std::int64_t kHalfExtent = std::int64_t{1} << 20;  // voxels: 21 bits a coordinate make a 63-bit Morton code
constexpr double kIntensityUnit = 256.0;
constexpr double kIntensityLimit = 1e9;  // so that 2^24 points cannot overflow a sum

/// The low 21 bits of v, two zeros after each.
std::uint64_t spread_bits(std::uint64_t v) {
  v &= 0x1FFFFF;
  v = (v | v << 32) & 0x001F00000000FFFF;
  v = (v | v << 16) & 0x001F0000FF0000FF;
  v = (v | v << 8) & 0x100F00F00F00F00F;
  v = (v | v << 4) & 0x10C30C30C30C30C3;
  v = (v | v << 2) & 0x1249249249249249;
  return v;
}

std::uint64_t gather_bits(std::uint64_t v) {
  v &= 0x1249249249249249;
  v = (v | v >> 2) & 0x10C30C30C30C30C3;
  v = (v | v >> 4) & 0x100F00F00F00F00F;
  v = (v | v >> 8) & 0x001F0000FF0000FF;
  v = (v | v >> 16) & 0x001F00000000FFFF;
  v = (v | v >> 32) & 0x00000000001FFFFF;
  return v;
}

std::int64_t fixed_intensity(float intensity) {
  if (!std::isfinite(intensity)) return 0;
  const double clamped = std::clamp(static_cast<double>(intensity), -kIntensityLimit, kIntensityLimit);
  return static_cast<std::int64_t>(std::floor(clamped * kIntensityUnit + 0.5));
}

/// The sums of `a` and `b`, both by key, into one by key.
template <class Voxel>
std::vector<Voxel> merged(const std::vector<Voxel>& a, const std::vector<Voxel>& b) {
  std::vector<Voxel> sum;
  sum.reserve(a.size() + b.size());
  std::merge(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(sum),
             [](const Voxel& p, const Voxel& q) { return p.key < q.key; });
  std::size_t last = 0;
  for (std::size_t i = 1; i < sum.size(); ++i) {
    if (sum[i].key != sum[last].key) {
      sum[++last] = sum[i];
      continue;
    }
    Voxel& voxel = sum[last];
    voxel.count += sum[i].count;
    voxel.with_intensity += sum[i].with_intensity;
    for (std::size_t k = 0; k < 3; ++k) voxel.offset_sum[k] += sum[i].offset_sum[k];
    voxel.intensity_sum += sum[i].intensity_sum;
  }
  if (!sum.empty()) sum.resize(last + 1);
  return sum;
}

}  // namespace

VoxelCloud::VoxelCloud(double voxel_m) : voxel_m_(voxel_m) {}

std::vector<VoxelCloud::Voxel> VoxelCloud::voxels_of(const MapPoints& points) {
  struct Entry {
    std::uint64_t key;
    std::uint32_t offset;  ///< Three times kFractionBits.
    std::uint32_t index;
  };
  std::vector<Entry> entries;
  entries.reserve(points.points.size());
  const double scale = static_cast<double>(kFractions) / voxel_m_;
  for (std::size_t i = 0; i < points.points.size(); ++i) {
    Entry entry{0, 0, static_cast<std::uint32_t>(i)};
    bool inside = true;
    for (int k = 0; k < 3; ++k) {
      const double fixed = std::floor(static_cast<double>(points.points[i][k]) * scale + 0.5);
      inside = inside && std::fabs(fixed) < static_cast<double>(kHalfExtent * kFractions);
      if (!inside) break;
      const auto units = static_cast<std::uint64_t>(static_cast<std::int64_t>(fixed) + kHalfExtent * kFractions);
      entry.key |= spread_bits(units >> kFractionBits) << k;
      entry.offset |= static_cast<std::uint32_t>(units & (kFractions - 1)) << (kFractionBits * k);
    }
    if (inside) entries.push_back(entry);
  }
  points_out_of_extent_ += points.points.size() - entries.size();
  radix_sort_by_key(entries);

  std::vector<Voxel> voxels;
  for (const Entry& entry : entries) {
    if (voxels.empty() || voxels.back().key != entry.key) voxels.push_back({.key = entry.key});
    Voxel& voxel = voxels.back();
    ++voxel.count;
    for (std::size_t k = 0; k < 3; ++k) voxel.offset_sum[k] += (entry.offset >> (kFractionBits * k)) & (kFractions - 1);
    if (points.intensity.empty()) continue;
    ++voxel.with_intensity;
    voxel.intensity_sum += fixed_intensity(points.intensity[entry.index]);
  }
  return voxels;
}

void VoxelCloud::add(const MapPoints& points) {
  const std::vector<Voxel> added = voxels_of(points);
  voxels_ = voxels_.empty() ? added : merged(voxels_, added);
}

PointCloud VoxelCloud::centroids() const {
  PointCloud cloud;
  cloud.points.reserve(voxels_.size());
  const bool with_intensity =
      std::any_of(voxels_.begin(), voxels_.end(), [](const Voxel& voxel) { return voxel.with_intensity > 0; });
  if (with_intensity) cloud.intensity.reserve(voxels_.size());
  const double unit = voxel_m_ / static_cast<double>(kFractions);
  for (const Voxel& voxel : voxels_) {
    Eigen::Vector3f point;
    for (int k = 0; k < 3; ++k) {
      const auto index = static_cast<std::int64_t>(gather_bits(voxel.key >> k)) - kHalfExtent;
      const double mean = static_cast<double>(voxel.offset_sum[static_cast<std::size_t>(k)]) / voxel.count;
      point[k] = static_cast<float>((static_cast<double>(index * kFractions) + mean) * unit);
    }
    cloud.points.push_back(point);
    if (!with_intensity) continue;
    const double sum = static_cast<double>(voxel.intensity_sum) / kIntensityUnit;
    cloud.intensity.push_back(voxel.with_intensity == 0 ? 0.0f : static_cast<float>(sum / voxel.with_intensity));
  }
  return cloud;
}

}  // namespace scanway
