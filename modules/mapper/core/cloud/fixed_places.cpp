#include "modules/mapper/core/cloud/fixed_places.h"

#include <bit>
#include <cmath>

#include "modules/mapper/core/cloud/voxel_place.h"

namespace scanway {
namespace {

constexpr double kHalfExtentFixed = 1 << (kExtentBits + kFractionBits);
/// Added to a number of not more than 2^51 it leaves no room for fractions; the sum's lowest bits are the integer.
constexpr double kRounding = 0x1.8p52;

}  // namespace

/// The coordinates one after the other: x, y and z are treated alike. Of operations that every CPU has for vectors, and
/// harmless for a place that is outside.
__attribute__((target_clones("default", "avx2", "avx512f"))) void fix_coordinates(const float* coordinates,
                                                                                  std::size_t count, double scale,
                                                                                  std::uint32_t* fixed) {
  for (std::size_t i = 0; i < count; ++i) {
    const double place = static_cast<double>(coordinates[i]) * scale + 0.5;
    const double rounded = (place + kRounding) - kRounding;
    const std::uint64_t nearest = std::bit_cast<std::uint64_t>(rounded + (kRounding + kHalfExtentFixed));
    const std::uint64_t floored = nearest - (rounded > place ? 1 : 0);
    const std::uint32_t outside = std::fabs(place) < kHalfExtentFixed ? 0 : FixedPlace::kOutside;  // and if NaN
    fixed[i] = static_cast<std::uint32_t>(floored) | outside;
  }
}

FixedPlace place_of_cube(std::uint64_t cube) {
  static_assert(FixedPlace::kInCubeBits == kCubeLevel + kFractionBits);
  const auto along = [cube](int axis) {
    return static_cast<std::uint32_t>(gather_bits(cube >> axis) << FixedPlace::kInCubeBits);
  };
  return {along(0), along(1), along(2)};
}

void fix_places(std::span<const Eigen::Vector3f> points, double voxel_m, std::vector<FixedPlace>& places) {
  static_assert(sizeof(Eigen::Vector3f) == 3 * sizeof(float) && sizeof(FixedPlace) == 3 * sizeof(std::uint32_t));
  places.resize(points.size());
  if (points.empty()) return;
  const double scale = static_cast<double>(kFractions) / voxel_m;
  fix_coordinates(points.front().data(), 3 * points.size(), scale, &places.front().x);
}

}  // namespace scanway
