#pragma once

#include <vector>

#include <Eigen/Core>

#include "modules/planner/core/path/ground.h"

namespace scanway::planning {

/// A pose in cells; cell (x, y) is the square of side 1 about the point (x, y).
struct CellPose {
  Eigen::Vector2d at;
  double heading = 0.0;  ///< Radians.
};

/// The poses along the legs: at each corner the heading of the leg before, then that of the leg behind. A turn of more
/// than 120 degrees has poses in between, so that from pose to pose the shorter way round is meant. Corners become arcs
/// of at most `most_radius` cells where the body passes and the arc costs no more than the corner.
std::vector<CellPose> poses_of(const std::vector<Leg>& legs, const Ground& ground, double most_radius);

}  // namespace scanway::planning
