#include "modules/simulator/core/laser/robot_body.h"

#include <algorithm>

namespace scanway::simulator {
namespace {

constexpr double kGroundClearance_m = 0.03;
constexpr double kLeastMirrorHeight_m = 0.05;
constexpr double kColumnRadius_m = 0.06;
constexpr double kLaserHalfHeight_m = 0.09;  // The laser's own housing about its mirror.

}  // namespace

Mesh body_mesh(const Robot& robot, const Pose& X_world_base) {
  const Surface surface{Material::bright_paint, Label::robot};
  const Pose X_base_pan = robot.mounts.base_mount.pose() * robot.mounts.mount_pan.pose();
  const double plate = robot.mounts.base_mount.position_m.z();
  const double mirror = (X_base_pan * robot.mounts.pan_laser.pose()).translation().z();
  Mesh mesh;
  if (mirror < plate + kLeastMirrorHeight_m) return mesh;
  if (plate > kGroundClearance_m) {
    add_prism(mesh, X_world_base, robot.body.footprint, kGroundClearance_m, plate, surface);
  }
  const double column = mirror - kLaserHalfHeight_m;
  if (column > plate) {
    const Pose X_world_column =
        X_world_base * Eigen::Translation3d(X_base_pan.translation().x(), X_base_pan.translation().y(), 0);
    add_cylinder(mesh, X_world_column, kColumnRadius_m, plate, column, surface, 12);
  }
  return mesh;
}

Robot simulated_robot() {
  Robot robot;
  robot.mounts.mount_pan.position_m = {0.0, 0.0, 0.22};
  robot.mounts.pan_laser.position_m = {0.03, 0.0, 0.16};
  return robot;
}

}  // namespace scanway::simulator
