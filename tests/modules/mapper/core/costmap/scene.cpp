#include "tests/modules/mapper/core/costmap/scene.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/random/random.h"

namespace scanway::testing {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double hit(const Box& box, const Eigen::Vector3d& origin, const Eigen::Vector3d& direction) {
  double enter = 0.0, leave = kInfinity;
  for (int i = 0; i < 3; ++i) {
    if (std::fabs(direction[i]) < 1e-12) {
      if (origin[i] < box.low[i] || origin[i] > box.high[i]) return kInfinity;
      continue;
    }
    const double a = (box.low[i] - origin[i]) / direction[i], b = (box.high[i] - origin[i]) / direction[i];
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  return enter <= leave ? enter : kInfinity;
}

}  // namespace

double Scene::cast(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction) const {
  double nearest = direction.z() < 0.0 ? -origin.z() / direction.z() : kInfinity;
  for (const Box& box : boxes) nearest = std::min(nearest, hit(box, origin, direction));
  return nearest;
}

bool Scene::visible(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const {
  const double distance = (to - from).norm();
  return cast(from, (to - from) / distance) >= distance - 1e-6;
}

bool Scene::blocks(double x, double y, double side, double low, double high) const {
  return std::any_of(boxes.begin(), boxes.end(), [&](const Box& box) {
    constexpr double kTouch = 1e-9;  // a box that ends at the cell's edge is outside
    return box.low.x() < x + side - kTouch && box.high.x() > x + kTouch && box.low.y() < y + side - kTouch &&
           box.high.y() > y + kTouch && box.low.z() < high && box.high.z() > low + kTouch;
  });
}

Sweep scan(const Scene& scene, const Eigen::Vector3d& origin, double pan_step_deg, double beam_step_deg,
           double range_sigma, std::uint64_t seed) {
  constexpr double kRadians = 3.14159265358979323846 / 180.0;
  Random random(seed);
  Sweep sweep;
  sweep.origin = origin;
  for (double pan = 0.0; pan < 360.0; pan += pan_step_deg) {
    for (double beam = -90.0; beam < 90.0; beam += beam_step_deg) {
      const double level = std::cos(beam * kRadians);
      const Eigen::Vector3d direction(level * std::cos(pan * kRadians), level * std::sin(pan * kRadians),
                                      std::sin(beam * kRadians));
      const double range = scene.cast(origin, direction) + range_sigma * random.normal();
      if (std::isfinite(range)) sweep.cloud.points.push_back((origin + range * direction).cast<float>());
    }
  }
  return sweep;
}

Scene furnished_room() {
  Scene scene;
  const auto box = [&](double x0, double x1, double y0, double y1, double z0, double z1) {
    scene.boxes.push_back({{x0, y0, z0}, {x1, y1, z1}});
  };
  box(-3.1, -3.0, -2.6, 2.6, 0.0, 2.5);  // walls
  box(-3.1, 3.1, -2.6, -2.5, 0.0, 2.5);
  box(-3.1, 3.1, 2.5, 2.6, 0.0, 2.5);
  box(3.0, 3.1, -2.6, 0.2, 0.0, 2.5);  // with a doorway of 0.9 m
  box(3.0, 3.1, 1.1, 2.6, 0.0, 2.5);
  box(3.0, 3.1, 0.2, 1.1, 2.0, 2.5);
  box(5.0, 5.1, -2.6, 2.6, 0.0, 2.5);     // the corridor behind it
  box(-3.1, 5.1, -2.6, 2.6, 2.5, 2.6);    // ceiling
  box(-2.0, -0.8, 1.2, 2.0, 0.71, 0.75);  // table
  for (const double x : {-2.0, -0.85}) {
    for (const double y : {1.2, 1.95}) box(x, x + 0.05, y, y + 0.05, 0.0, 0.71);
  }
  box(1.2, 1.5, 1.0, 1.3, 0.0, 2.5);       // pillar
  box(-1.0, 1.0, -2.5, -2.2, 1.6, 1.65);   // shelf
  box(1.4, 2.4, -1.8, -0.8, 0.0, 0.02);    // a slab that is climbed
  box(-2.4, -1.6, -1.6, -0.8, 0.0, 0.05);  // and one that is not
  return scene;
}

}  // namespace scanway::testing
