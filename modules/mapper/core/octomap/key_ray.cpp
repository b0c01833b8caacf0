#include "modules/mapper/core/octomap/key_ray.h"

#include <cmath>
#include <cstdlib>
#include <limits>

namespace scanway {
namespace {

// A border is passed a step early or late only within rounding, so at most once an axis; twice that for the proof.
constexpr std::int64_t kUnsureSteps = 6;

}  // namespace

KeyRays::KeyRays(const KeyGrid& grid, const octomap::point3d& origin)
    : grid_(grid), origin_(origin), origin_inside_(grid.key_of(origin, origin_key_)), to_border_{} {
  if (!origin_inside_) return;
  origin_code_ = morton_code(origin_key_);
  for (unsigned axis = 0; axis < 3; ++axis) {
    for (const int up : {0, 1}) {
      double border = grid_.centre(origin_key_[axis]);
      border += static_cast<float>((up ? 1 : -1) * grid_.resolution() * 0.5);
      to_border_[axis][up] = border - origin_(axis);
    }
  }
}

bool KeyRays::start(const octomap::point3d& end, KeyRay& ray) const {
  octomap::OcTreeKey end_key;
  if (!origin_inside_ || !grid_.key_of(end, end_key) || end_key == origin_key_) return false;
  octomap::point3d direction = end - origin_;
  const auto length = static_cast<float>(direction.norm());
  direction /= length;
  ray.length_m = length;
  ray.mirror = 0;
  ray.sure_steps = -kUnsureSteps;
  for (unsigned axis = 0; axis < 3; ++axis) {
    ray.sure_steps += std::abs(int{end_key[axis]} - int{origin_key_[axis]});
    const float along = direction(axis);
    if (along > 0.0f || along < 0.0f) {
      ray.border_m[axis] = to_border_[axis][along > 0.0f] / along;
      ray.between_m[axis] = grid_.resolution() / std::fabs(along);
      if (along < 0.0f) ray.mirror |= kAxisBits[axis];
    } else {
      ray.border_m[axis] = std::numeric_limits<double>::max();
      ray.between_m[axis] = std::numeric_limits<double>::max();
    }
  }
  ray.code = origin_code_ ^ ray.mirror;
  ray.end = morton_code(end_key) ^ ray.mirror;
  return true;
}

}  // namespace scanway
