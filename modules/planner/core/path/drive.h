#pragma once

#include <vector>

#include "common/robot/robot.h"
#include "modules/planner/core/path/path_pose.h"

namespace scanway::planning {

/// The radius of a bend in which the body need not slow down, in metres.
double widest_bend(const Robot::Body& body);

/// Fills in times and speeds: as fast as the body's limits allow. It stands still where it turns in place and where it
/// changes between forwards and backwards; in a bend its sideways acceleration and its turn rate are limited. Poses are
/// added where it stops speeding up and where it begins to brake, so that from pose to pose the speed changes evenly.
std::vector<PathPose> driven(const std::vector<PathPose>& path, const Robot::Body& body);

}  // namespace scanway::planning
