#include "modules/mapper/core/cloud/surface_normals.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include "common/parallel/blocks.h"
#include "modules/mapper/core/cloud/plane_fit.h"
#include "modules/mapper/core/cloud/voxel_place.h"

namespace scanway {
namespace {

constexpr int kLargest = 7, kSmallest = 3;  // cubes of 2^level voxels a side
constexpr int kMinVoxels = 8;
constexpr double kMostAcross = 1.5 * 1.5;    // voxels^2: the noise of a laser that such voxels are fit for
constexpr double kMostDeviation = 5.0;       // voxels
constexpr double kLeastAlong = 1.0;          // voxels^2: less is a line
constexpr double kMostAcrossOfAlong = 0.25;  // more is a tuft
constexpr std::size_t kCubesInBlock = 64;

using Voxels = std::span<VoxelSum>;
using Places = std::span<const Eigen::Vector3d>;  // Of voxels, in voxels from the corner of their largest cube.

std::uint64_t cube_of(const VoxelSum& voxel, int level) { return voxel.key >> (3 * level); }

/// Where cubes of that level begin, and at last where all end.
std::vector<std::size_t> begins_of_cubes(const std::vector<VoxelSum>& voxels, int level) {
  std::vector<std::size_t> begins;
  for (std::size_t i = 0; i < voxels.size(); ++i) {
    if (i == 0 || cube_of(voxels[i], level) != cube_of(voxels[i - 1], level)) begins.push_back(i);
  }
  begins.push_back(voxels.size());
  return begins;
}

/// What one thread needs to work on one largest cube after the other.
class CubeNormals {
 public:
  CubeNormals(const Eigen::Vector3d& origin_voxels) : origin_(origin_voxels) {}

  void set(Voxels voxels) {
    const Eigen::Vector3d corner = corner_of(cube_of(voxels.front(), kLargest) << (3 * kLargest));
    places_.clear();
    for (const VoxelSum& voxel : voxels) places_.push_back(place_of(voxel) - corner);
    towards_ = origin_ - corner;
    set(voxels, places_, kLargest);
  }

 private:
  void set(Voxels voxels, Places places, int level) {
    if (voxels.size() < kMinVoxels) return;
    Moments moments;
    for (const Eigen::Vector3d& place : places) moments.add(place);
    const PlaneFit plane = fit_plane(moments);
    if (is_plane(plane, places, level)) return give(plane, voxels);
    if (level > kSmallest) split(voxels, places, level - 1);
  }

  void split(Voxels voxels, Places places, int level) {
    while (!voxels.empty()) {
      const std::uint64_t cube = cube_of(voxels.front(), level);
      const auto end = std::find_if(voxels.begin(), voxels.end(),
                                    [cube, level](const VoxelSum& voxel) { return cube_of(voxel, level) != cube; });
      const auto count = static_cast<std::size_t>(end - voxels.begin());
      set(voxels.first(count), places.first(count), level);
      voxels = voxels.subspan(count);
      places = places.subspan(count);
    }
  }

  static bool is_plane(const PlaneFit& plane, Places places, int level) {
    if (plane.along < kLeastAlong) return false;
    if (plane.across > kMostAcross || plane.across > kMostAcrossOfAlong * plane.along) return false;
    if (level == kSmallest) return true;
    return std::all_of(places.begin(), places.end(), [&plane](const Eigen::Vector3d& place) {
      return std::fabs(plane.normal.dot(place - plane.mean)) <= kMostDeviation;
    });
  }

  void give(const PlaneFit& plane, Voxels voxels) const {
    const double side = plane.normal.dot(towards_ - plane.mean) < 0.0 ? -1.0 : 1.0;
    std::array<std::int32_t, 3> normal{};
    for (std::size_t k = 0; k < 3; ++k) {
      const double component = side * plane.normal[static_cast<int>(k)];
      normal[k] = static_cast<std::int32_t>(std::floor(component * kNormalUnit + 0.5));
    }
    for (VoxelSum& voxel : voxels) voxel.set_normal(normal);
  }

  Eigen::Vector3d origin_, towards_;
  std::vector<Eigen::Vector3d> places_;
};

}  // namespace

void set_normals(std::vector<VoxelSum>& voxels, const Eigen::Vector3d& origin, double voxel_m) {
  const std::vector<std::size_t> begins = begins_of_cubes(voxels, kLargest);
  for_blocks(begins.size() - 1, kCubesInBlock, [&](std::size_t first, std::size_t last, std::size_t) {
    CubeNormals cubes(origin / voxel_m);
    for (std::size_t i = first; i < last; ++i) cubes.set(Voxels(voxels).subspan(begins[i], begins[i + 1] - begins[i]));
  });
}

}  // namespace scanway
