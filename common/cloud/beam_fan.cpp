#include "common/cloud/beam_fan.h"

#include <algorithm>
#include <cmath>

namespace scanway {
namespace {

constexpr double kCounts = 32767.0;
constexpr int kMostBeams = 1000;

Eigen::Vector3d vector_of(const BeamFan::Direction& direction) {
  return Eigen::Vector3d(direction[0], direction[1], direction[2]);
}

}  // namespace

// A straight line between the ends instead of an arc: over 0.2 rad that is off by less than 0.0001 rad.
Eigen::Vector3d BeamFan::direction(int i) const {
  const double share = beams < 2 ? 0.0 : static_cast<double>(i) / (beams - 1);
  return (vector_of(first) * (1.0 - share) + vector_of(last) * share).normalized();
}

BeamFan::Direction to_direction(const Eigen::Vector3d& unit) {
  const auto count = [](double value) {
    return static_cast<std::int16_t>(std::floor(std::clamp(value, -1.0, 1.0) * kCounts + 0.5));
  };
  return {count(unit.x()), count(unit.y()), count(unit.z())};
}

int most_beams_of_fan(double step_rad) {
  const double steps = std::floor(kWidestFan_rad / std::max(1e-9, std::fabs(step_rad)));
  return 1 + static_cast<int>(std::min<double>(kMostBeams - 1, steps));
}

}  // namespace scanway
