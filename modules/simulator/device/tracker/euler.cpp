#include "modules/simulator/device/tracker/euler.h"

#include <cmath>

#include "common/math/repeatable.h"

namespace scanway::simulator {

std::array<double, 3> euler_deg(const Eigen::Matrix3d& R) {
  const double degree = repeatable::kPi / 180.0;
  const double roll = repeatable::atan2(R(2, 1), R(2, 2)), yaw = repeatable::atan2(R(1, 0), R(0, 0));
  const double pitch = repeatable::atan2(-R(2, 0), std::sqrt(R(2, 1) * R(2, 1) + R(2, 2) * R(2, 2)));
  return {roll / degree, pitch / degree, yaw / degree};
}

}  // namespace scanway::simulator
