#pragma once

#include "common/geometry/pose.h"
#include "common/robot/robot.h"
#include "modules/simulator/core/world/mesh.h"

namespace scanway::simulator {

/// The robot as its own laser sees it: the body up to its plate, and the pan-tilt's column up to just below the laser.
/// Empty where the robot file does not say where the laser is: with the mirror in its plate it would see nothing else.
Mesh body_mesh(const Robot& robot, const Pose& X_world_base);

/// The ERA-Mobi with the sizes of the devices on it: the pan axis 0.22 m above the plate, the mirror 0.16 m above that
/// and 0.03 m ahead of it. (The built-in robot leaves both at 0, for the user to measure.)
Robot simulated_robot();

}  // namespace scanway::simulator
