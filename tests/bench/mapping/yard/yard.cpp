#include "tests/bench/mapping/yard/yard.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/math/repeatable.h"
#include "common/random/random.h"

namespace scanway::bench {
namespace {

constexpr double kHalfSide = 20.0;
constexpr double kSensorHeight = 1.4;

struct Box {
  Eigen::Vector3d low, high;
};

std::vector<Box> boxes() {
  Random random(40);
  std::vector<Box> boxes;
  for (int i = 0; i < 60; ++i) {
    const double x = (random.uniform() * 2.0 - 1.0) * 18.0;
    const double y = (random.uniform() * 2.0 - 1.0) * 18.0;
    const bool pole = i % 3 == 0;
    const double side = pole ? 0.15 : 0.4 + random.uniform();
    const double height = pole ? 4.0 : 0.4 + 2.0 * random.uniform();
    if (std::max(std::abs(x), std::abs(y)) > 3.0) boxes.push_back({{x, y, -1.0}, {x + side, y + side, height}});
  }
  return boxes;
}

/// The range at which a ray from inside the yard meets the ground (rough, so `height`), a wall or the sky's end.
double range_of_yard(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction, double height) {
  double range = 60.0;
  if (direction.z() < 0.0) range = std::min(range, (height - origin.z()) / direction.z());
  for (int axis = 0; axis < 2; ++axis) {
    if (direction[axis] == 0.0) continue;
    range = std::min(range, ((direction[axis] > 0.0 ? kHalfSide : -kHalfSide) - origin[axis]) / direction[axis]);
  }
  return range;
}

double range_of_box(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction, const Box& box) {
  double in = 0.0, out = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    const double a = (box.low[axis] - origin[axis]) / direction[axis];
    const double b = (box.high[axis] - origin[axis]) / direction[axis];
    in = std::max(in, std::min(a, b));
    out = std::min(out, std::max(a, b));
  }
  return in < out && in > 0.0 ? in : std::numeric_limits<double>::infinity();
}

}  // namespace

MapPoints yard_sweep(int number, int steps_round, int steps_up) {
  const std::vector<Box> things = boxes();
  Random random(static_cast<std::uint64_t>(number) + 1);
  MapPoints sweep;
  sweep.origin = Eigen::Vector3d(0.31 + 0.7 * number, -0.17 + 0.4 * number, kSensorHeight);
  for (int i = 0; i < steps_round; ++i) {
    const double heading = 2.0 * repeatable::kPi * (i + 0.3) / steps_round;
    for (int j = 0; j < steps_up; ++j) {
      const double up = repeatable::kPi * (-0.40 + 0.55 * (j + 0.3) / steps_up);
      const Eigen::Vector3d direction(std::cos(up) * std::cos(heading), std::cos(up) * std::sin(heading), std::sin(up));
      double range = range_of_yard(sweep.origin, direction, 0.01 * random.normal());
      for (const Box& box : things) range = std::min(range, range_of_box(sweep.origin, direction, box));
      const Eigen::Vector3d p = sweep.origin + direction * (range + 0.003 * random.normal());
      sweep.points.push_back(p.cast<float>());
    }
  }
  return sweep;
}

}  // namespace scanway::bench
