#include "modules/mapper/core/cloud/surface_normals.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "modules/mapper/core/cloud/voxel_place.h"

namespace scanway {
namespace {

constexpr int kSmallest = 3;  // cubes of 2^level voxels a side
constexpr int kMinVoxels = 8;
constexpr double kMostAcross = 1.5 * 1.5;    // voxels^2: the noise of a laser that such voxels are fit for
constexpr double kMostDeviation = 5.0;       // voxels
constexpr double kLeastAlong = 1.0;          // voxels^2: less is a line
constexpr double kMostAcrossOfAlong = 0.25;  // more is a tuft

std::uint64_t part_of(const VoxelSum& voxel, int level) { return voxel.key >> (3 * level); }

bool is_plane(const PlaneFit& plane, std::span<const Eigen::Vector3d> places, int level) {
  if (plane.along < kLeastAlong) return false;
  if (plane.across > kMostAcross || plane.across > kMostAcrossOfAlong * plane.along) return false;
  if (level == kSmallest) return true;
  return std::all_of(places.begin(), places.end(), [&plane](const Eigen::Vector3d& place) {
    return std::fabs(plane.normal.dot(place - plane.mean)) <= kMostDeviation;
  });
}

}  // namespace

void SurfaceNormals::set(Voxels cube) {
  const PlacesInCube& in_cube = PlacesInCube::table();
  places_.clear();
  for (const VoxelSum& voxel : cube) places_.push_back(in_cube.place(voxel));
  towards_ = origin_ - corner_of_cube(cube_of(cube.front().key));
  set(cube, places_, kCubeLevel);
}

void SurfaceNormals::set(Voxels voxels, Places places, int level) const {
  if (voxels.size() < kMinVoxels) return;
  Moments moments;
  for (const Eigen::Vector3d& place : places) moments.add(place);
  const PlaneFit plane = fit_plane(moments);
  if (is_plane(plane, places, level)) return give(plane, voxels);
  if (level > kSmallest) split(voxels, places, level - 1);
}

void SurfaceNormals::split(Voxels voxels, Places places, int level) const {
  while (!voxels.empty()) {
    const std::uint64_t part = part_of(voxels.front(), level);
    const auto end = std::find_if(voxels.begin(), voxels.end(),
                                  [part, level](const VoxelSum& voxel) { return part_of(voxel, level) != part; });
    const auto count = static_cast<std::size_t>(end - voxels.begin());
    set(voxels.first(count), places.first(count), level);
    voxels = voxels.subspan(count);
    places = places.subspan(count);
  }
}

void SurfaceNormals::give(const PlaneFit& plane, Voxels voxels) const {
  const double side = plane.normal.dot(towards_ - plane.mean) < 0.0 ? -1.0 : 1.0;
  std::array<std::int32_t, 3> normal{};
  for (std::size_t k = 0; k < 3; ++k) {
    const double component = side * plane.normal[static_cast<int>(k)];
    normal[k] = static_cast<std::int32_t>(std::floor(component * kNormalUnit + 0.5));
  }
  for (VoxelSum& voxel : voxels) voxel.set_normal(normal);
}

}  // namespace scanway
