#pragma once

#include <cmath>

#include "modules/simulator/core/simulator.h"

namespace scanway::simulator::test {

/// The inside of a box, as six planes whose distances can be written down.
struct Room {
  Eigen::Vector3d low{-5.0, -3.0, 0.0}, high{4.0, 6.0, 3.0};

  World world() const {
    World world;
    world.name = "room";
    world.extent = {low.head<2>(), high.head<2>()};
    GroundPlan plan;
    plan.extent = world.extent;
    plan.material = Material::plaster;
    world.ground = plan.mesh();
    const Surface wall{Material::plaster, Label::building};
    const double t = 0.5;
    add_block(world.objects, {low.x() - t, low.y() - t, -t}, {low.x(), high.y() + t, high.z() + t}, wall);
    add_block(world.objects, {high.x(), low.y() - t, -t}, {high.x() + t, high.y() + t, high.z() + t}, wall);
    add_block(world.objects, {low.x(), low.y() - t, -t}, {high.x(), low.y(), high.z() + t}, wall);
    add_block(world.objects, {low.x(), high.y(), -t}, {high.x(), high.y() + t, high.z() + t}, wall);
    add_block(world.objects, {low.x(), low.y(), high.z()}, {high.x(), high.y(), high.z() + t}, wall);
    return world;
  }

  /// Distance from `origin`, inside, along `direction` to the first wall, and how much farther the next plane is.
  std::pair<double, double> distance(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction) const {
    double first = 1e9, second = 1e9;
    for (int axis = 0; axis < 3; ++axis) {
      if (direction[axis] == 0.0) continue;
      const double plane = direction[axis] > 0 ? high[axis] : low[axis];
      const double range = (plane - origin[axis]) / direction[axis];
      if (range < first) {
        second = first;
        first = range;
      } else if (range < second) {
        second = range;
      }
    }
    return {first, second - first};
  }
};

/// A robot whose sweeps are small: 300 lines of 191 beams.
inline Robot quick_robot() {
  Robot robot = simulated_robot();
  robot.laser.beams = 191;
  robot.pan.speed_rad_s = radians(30);
  return robot;
}

inline Pose tilted_pose(double x, double y, double z, double heading) {
  Pose X = Pose::Identity();
  X.linear() = rotation_about_z(heading) * exp_so3({0.03, -0.02, 0.0});
  X.translation() = Eigen::Vector3d(x, y, z);
  return X;
}

inline bool operator==(const BeamReading& a, const BeamReading& b) {
  return a.range_count == b.range_count && a.rssi_count == b.rssi_count && a.label == b.label;
}

}  // namespace scanway::simulator::test
