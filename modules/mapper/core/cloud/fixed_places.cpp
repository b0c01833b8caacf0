#include "modules/mapper/core/cloud/fixed_places.h"

#include <cmath>

#include "modules/mapper/core/cloud/voxel_place.h"

namespace scanway {
namespace {

constexpr std::int32_t kHalfExtentFixed = 1 << (kExtentBits + kFractionBits);

}  // namespace

/// The coordinates one after the other: x, y and z are treated alike.
__attribute__((target_clones("default", "avx2", "avx512f"))) void fix_coordinates(const float* coordinates,
                                                                                  std::size_t count, double scale,
                                                                                  std::uint32_t* fixed) {
  for (std::size_t i = 0; i < count; ++i) {
    const double place = static_cast<double>(coordinates[i]) * scale + 0.5;
    const bool inside = std::fabs(place) < static_cast<double>(kHalfExtentFixed);  // NaN is not
    const double sure = inside ? place : 0.0;
    const auto truncated = static_cast<std::int32_t>(sure);
    const std::int32_t floored = truncated - (static_cast<double>(truncated) > sure ? 1 : 0);
    fixed[i] = inside ? static_cast<std::uint32_t>(floored + kHalfExtentFixed) : FixedPlace::kOutside;
  }
}

void fix_places(std::span<const Eigen::Vector3f> points, double voxel_m, std::vector<FixedPlace>& places) {
  static_assert(sizeof(Eigen::Vector3f) == 3 * sizeof(float) && sizeof(FixedPlace) == 3 * sizeof(std::uint32_t));
  places.resize(points.size());
  if (points.empty()) return;
  const double scale = static_cast<double>(kFractions) / voxel_m;
  fix_coordinates(points.front().data(), 3 * points.size(), scale, &places.front().x);
}

}  // namespace scanway
