#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace scanway {

/// What the points in one voxel sum up to. Offsets are from the voxel's lowest corner, in 1024ths of its side;
/// intensities are in 256ths, normals in 127ths.
struct VoxelSum {
  std::uint64_t key = 0;  ///< Morton code of the voxel's index.
  std::uint32_t count = 0;
  std::uint32_t with_intensity = 0;
  std::array<std::uint64_t, 3> offset_sum{};
  std::int64_t intensity_sum = 0;
  std::array<std::int32_t, 3> normal_sum{};

  bool operator==(const VoxelSum&) const = default;
  bool has_normal(const std::array<std::int32_t, 3>& normal) const {
    const auto points = static_cast<std::int32_t>(count);
    return normal_sum[0] == normal[0] * points && normal_sum[1] == normal[1] * points &&
           normal_sum[2] == normal[2] * points;
  }
  /// Of points that all have the same.
  std::array<std::int32_t, 3> normal() const {
    const auto points = static_cast<std::int32_t>(count);
    return {normal_sum[0] / points, normal_sum[1] / points, normal_sum[2] / points};
  }
  void set_normal(const std::array<std::int32_t, 3>& normal) {
    for (std::size_t k = 0; k < 3; ++k) normal_sum[k] = normal[k] * static_cast<std::int32_t>(count);
  }
};

constexpr double kIntensityUnit = 256.0;
constexpr double kNormalUnit = 127.0;

/// Sorts sums by key and adds up those of one voxel. Integers: the order in which they come does not matter.
void add_up(std::vector<VoxelSum>& sums);

}  // namespace scanway
