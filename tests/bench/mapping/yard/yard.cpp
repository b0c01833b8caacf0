#include "tests/bench/mapping/yard/yard.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/math/repeatable.h"
#include "common/random/random.h"

namespace scanway::bench {
namespace {

constexpr double kSensorHeight = 1.4;
constexpr double kNoEnd = std::numeric_limits<double>::infinity();

struct Box {
  Eigen::Vector3d low, high;
};

/// A walled rectangle about the origin, and what stands in it.
struct Yard {
  double half_x = 20.0, half_y = 20.0;
  double wall = kNoEnd;  ///< Its height; over it there is the sky.
  std::vector<Box> things;
};

Yard small_yard() {
  Random random(40);
  Yard yard;
  for (int i = 0; i < 60; ++i) {
    const double x = (random.uniform() * 2.0 - 1.0) * 18.0;
    const double y = (random.uniform() * 2.0 - 1.0) * 18.0;
    const bool pole = i % 3 == 0;
    const double side = pole ? 0.15 : 0.4 + random.uniform();
    const double height = pole ? 4.0 : 0.4 + 2.0 * random.uniform();
    if (std::max(std::abs(x), std::abs(y)) > 3.0) yard.things.push_back({{x, y, -1.0}, {x + side, y + side, height}});
  }
  return yard;
}

/// Sheds, boxes and poles between the lanes that the robot drives.
Yard site() {
  Random random(41);
  Yard yard{50.0, 30.0, 4.0, {}};
  for (int i = 0; i < 120; ++i) {
    const double x = (random.uniform() * 2.0 - 1.0) * 48.0;
    const double y = kSiteLane_m * (static_cast<double>(random.below(5)) - 2.0) + 1.0 + 8.0 * random.uniform();
    const double side = i % 10 == 0 ? 3.0 : i % 3 == 0 ? 0.15 : 0.4 + random.uniform();
    const double height = i % 3 == 0 ? 4.0 : 0.4 + 2.0 * random.uniform();
    yard.things.push_back({{x, y, -1.0}, {x + side, y + std::min(side, 1.5), height}});
  }
  return yard;
}

/// The things that a beam of that heading may meet, whatever its elevation: a millimetre is far more than rounding.
std::vector<Box> things_towards(const Yard& yard, const Eigen::Vector3d& origin, double heading) {
  const Eigen::Vector2d ahead(std::cos(heading), std::sin(heading)), left(-ahead.y(), ahead.x());
  std::vector<Box> things;
  for (const Box& box : yard.things) {
    const Eigen::Vector2d centre = (box.low + box.high).head<2>() / 2.0 - origin.head<2>();
    const Eigen::Vector2d half = (box.high - box.low).head<2>() / 2.0 + Eigen::Vector2d::Constant(0.001);
    if (std::abs(centre.dot(left)) <= half.dot(left.cwiseAbs()) && centre.dot(ahead) + half.norm() >= 0.0) {
      things.push_back(box);
    }
  }
  return things;
}

/// The range at which a ray from inside the yard meets the ground (rough, so `height`), a wall or the sky's end.
double range_of_walls(const Yard& yard, const Eigen::Vector3d& origin, const Eigen::Vector3d& direction,
                      double height) {
  const double half[2] = {yard.half_x, yard.half_y};
  double range = 60.0;
  if (direction.z() < 0.0) range = std::min(range, (height - origin.z()) / direction.z());
  for (int axis = 0; axis < 2; ++axis) {
    if (direction[axis] == 0.0) continue;
    range = std::min(range, ((direction[axis] > 0.0 ? half[axis] : -half[axis]) - origin[axis]) / direction[axis]);
  }
  return range;
}

double range_of_box(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction, const Box& box) {
  double in = 0.0, out = kNoEnd;
  for (int axis = 0; axis < 3; ++axis) {
    const double a = (box.low[axis] - origin[axis]) / direction[axis];
    const double b = (box.high[axis] - origin[axis]) / direction[axis];
    in = std::max(in, std::min(a, b));
    out = std::min(out, std::max(a, b));
  }
  return in < out && in > 0.0 ? in : kNoEnd;
}

MapPoints sweep_of(const Yard& yard, const Eigen::Vector3d& origin, std::uint64_t seed, int steps_round, int steps_up) {
  Random random(seed);
  MapPoints sweep;
  sweep.origin = origin;
  for (int i = 0; i < steps_round; ++i) {
    const double heading = 2.0 * repeatable::kPi * (i + 0.3) / steps_round;
    const std::vector<Box> things = things_towards(yard, origin, heading);
    for (int j = 0; j < steps_up; ++j) {
      const double up = repeatable::kPi * (-0.40 + 0.55 * (j + 0.3) / steps_up);
      const Eigen::Vector3d direction(std::cos(up) * std::cos(heading), std::cos(up) * std::sin(heading), std::sin(up));
      double range = range_of_walls(yard, sweep.origin, direction, 0.01 * random.normal());
      for (const Box& box : things) range = std::min(range, range_of_box(sweep.origin, direction, box));
      const Eigen::Vector3d p = sweep.origin + direction * (range + 0.003 * random.normal());
      if (p.z() < yard.wall) sweep.points.push_back(p.cast<float>());
    }
  }
  return sweep;
}

}  // namespace

MapPoints yard_sweep(int number, int steps_round, int steps_up) {
  static const Yard yard = small_yard();
  const Eigen::Vector3d origin(0.31 + 0.7 * number, -0.17 + 0.4 * number, kSensorHeight);
  return sweep_of(yard, origin, static_cast<std::uint64_t>(number) + 1, steps_round, steps_up);
}

MapPoints site_sweep(int number, int steps_round, int steps_up) {
  static const Yard yard = site();
  const int lane = number / kSiteStops % 5,
            stop = lane % 2 == 0 ? number % kSiteStops : kSiteStops - 1 - number % kSiteStops;
  const Eigen::Vector3d origin(9.5 * stop - 42.7, kSiteLane_m * (lane - 2) + 0.13, kSensorHeight);
  return sweep_of(yard, origin, static_cast<std::uint64_t>(number) + 1, steps_round, steps_up);
}

}  // namespace scanway::bench
