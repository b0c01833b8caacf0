#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "common/geometry/pose.h"
#include "common/random/random.h"
#include "common/time/utime.h"
#include "modules/simulator/core/ray/ray_caster.h"

namespace scanway::simulator {

/// How somebody walks: to and fro on a straight way over the ground, at an even pace.
class Walk {
 public:
  /// A way of 2 to 8 m within `kReach_m` of `place`, 1 m from it at the nearest, on which nothing stands. Nothing if
  /// the random numbers find none.
  static std::optional<Walk> find(const RayCaster& world, const Eigen::Vector3d& place, Random& random);

  /// Feet on the ground, x ahead, z up.
  Pose X_world_person(double time_us) const;

  static constexpr double kReach_m = 9.0;

 private:
  Walk(const Eigen::Vector2d& from, const Eigen::Vector2d& to, std::vector<double> ground, Random& random);

  Eigen::Vector2d from_, ahead_;
  double length_m_, speed_m_s_, start_m_;
  std::vector<double> ground_;  // Its height, evenly along the way.
};

}  // namespace scanway::simulator
