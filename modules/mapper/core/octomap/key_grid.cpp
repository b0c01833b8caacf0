#include "modules/mapper/core/octomap/key_grid.h"

#include <cmath>
#include <limits>

namespace scanway {
namespace {

constexpr int kCentreKey = 32768;

}  // namespace

int KeyGrid::voxel_of(double coordinate) const {
  const double voxel = std::floor(factor_ * coordinate);
  // C++ leaves open what such a number becomes as an int; this is what x86 makes of it, and so OctoMap there.
  if (!(voxel >= -2147483648.0 && voxel < 2147483648.0)) return std::numeric_limits<int>::min();
  return static_cast<int>(voxel);
}

bool KeyGrid::key_of(const octomap::point3d& point, octomap::OcTreeKey& key) const {
  for (unsigned axis = 0; axis < 3; ++axis) {
    const int voxel = voxel_of(point(axis));
    if (voxel < -kCentreKey || voxel >= kCentreKey) return false;
    key[axis] = static_cast<octomap::key_type>(voxel + kCentreKey);
  }
  return true;
}

octomap::OcTreeKey KeyGrid::wrapped_key_of(const octomap::point3d& point) const {
  octomap::OcTreeKey key;
  for (unsigned axis = 0; axis < 3; ++axis) {
    key[axis] = static_cast<octomap::key_type>(static_cast<unsigned>(voxel_of(point(axis))) + kCentreKey);
  }
  return key;
}

double KeyGrid::centre(octomap::key_type key) const { return (double(int{key} - kCentreKey) + 0.5) * resolution_; }

octomap::point3d KeyGrid::centre(const octomap::OcTreeKey& key) const {
  return {float(centre(key[0])), float(centre(key[1])), float(centre(key[2]))};
}

}  // namespace scanway
