#include "modules/mapper/core/cloud/cube_runs.h"

#include <algorithm>

#include "modules/mapper/core/cloud/fixed_places.h"
#include "modules/mapper/core/cloud/radix_sort.h"
#include "modules/mapper/core/cloud/voxel_place.h"

namespace scanway {
namespace {

constexpr std::size_t kPointsAtOnce = 1024;
constexpr int kInCubeBits = kCubeLevel + kFractionBits;

bool in_one_cube(const FixedPlace& a, const FixedPlace& b) {
  return ((a.x ^ b.x) | (a.y ^ b.y) | (a.z ^ b.z)) >> kInCubeBits == 0;
}

std::uint64_t cube_of(const FixedPlace& place) {
  return spread_bits(place.x >> kInCubeBits) | spread_bits(place.y >> kInCubeBits) << 1 |
         spread_bits(place.z >> kInCubeBits) << 2;
}

}  // namespace

std::vector<CubeRun> cube_runs(std::span<const Eigen::Vector3f> points, double voxel_m) {
  std::vector<CubeRun> runs;
  std::vector<FixedPlace> places;
  FixedPlace last{FixedPlace::kOutside, 0, 0};
  for (std::size_t begin = 0; begin < points.size(); begin += kPointsAtOnce) {
    fix_places(points.subspan(begin, std::min(kPointsAtOnce, points.size() - begin)), voxel_m, places);
    for (std::size_t i = 0; i < places.size(); ++i) {
      const bool same = in_one_cube(places[i], last);
      last = places[i];
      if (last.is_outside()) continue;
      if (!same) runs.push_back({cube_of(last), static_cast<std::uint32_t>(begin + i), 0});
      ++runs.back().count;
    }
  }
  radix_sort_by_key(runs);
  return runs;
}

}  // namespace scanway
