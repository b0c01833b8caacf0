#include "modules/mapper/core/cloud/cube_runs.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "modules/mapper/core/cloud/fixed_places.h"
#include "modules/mapper/core/cloud/radix_sort.h"
#include "modules/mapper/core/cloud/voxel_place.h"

namespace scanway {
namespace {

constexpr std::size_t kPointsAtOnce = 1024;
std::uint64_t cube_of(const FixedPlace& place) {
  return spread_bits(place.x >> FixedPlace::kInCubeBits) | spread_bits(place.y >> FixedPlace::kInCubeBits) << 1 |
         spread_bits(place.z >> FixedPlace::kInCubeBits) << 2;
}

/// Two runs that go on.
class OpenRuns {
 public:
  void visit(const FixedPlace& place, std::uint32_t point) {
    if (place.is_outside()) return;
    const bool second = place.is_in_cube_of(open_[1].somewhere);
    if (!second && !place.is_in_cube_of(open_[0].somewhere)) return begin(place, point);
    open_[second].last = point;
  }
  std::vector<CubeRun> finish() {
    close(open_[0]);
    close(open_[1]);
    return std::move(closed_);
  }

 private:
  struct Open {
    FixedPlace somewhere{FixedPlace::kOutside, 0, 0};
    std::uint32_t first = 0, last = 0;
  };

  /// In place of the run that was left the longer ago.
  void begin(const FixedPlace& place, std::uint32_t point) {
    Open& run = open_[open_[0].last < open_[1].last ? 0 : 1];
    close(run);
    run = {place, point, point};
  }
  void close(const Open& run) {
    if (!run.somewhere.is_outside()) closed_.push_back({cube_of(run.somewhere), run.first, run.last - run.first + 1});
  }

  std::array<Open, 2> open_;
  std::vector<CubeRun> closed_;
};

}  // namespace

std::vector<CubeRun> cube_runs(std::span<const Eigen::Vector3f> points, double voxel_m) {
  OpenRuns open;
  std::vector<FixedPlace> places;
  for (std::size_t begin = 0; begin < points.size(); begin += kPointsAtOnce) {
    fix_places(points.subspan(begin, std::min(kPointsAtOnce, points.size() - begin)), voxel_m, places);
    for (std::size_t i = 0; i < places.size(); ++i) open.visit(places[i], static_cast<std::uint32_t>(begin + i));
  }
  std::vector<CubeRun> runs = open.finish();
  radix_sort_by_key(runs);
  return runs;
}

}  // namespace scanway
