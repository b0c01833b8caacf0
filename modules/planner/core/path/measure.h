#pragma once

#include <vector>

#include <Eigen/Core>

#include "modules/planner/core/path/ground.h"
#include "modules/planner/core/path/map_scale.h"
#include "modules/planner/core/path/path_pose.h"

namespace scanway::planning {

/// What a path is like, in metres; PlanResult says what each means.
struct PathMeasures {
  double length_m = 0.0;
  double worst_cost = 0.0;
  double clearance_m = 0.0;
  Eigen::Vector2d clearance_at_m = Eigen::Vector2d::Zero();
  double unknown_share = 0.0;
};

PathMeasures measures_of(const std::vector<PathPose>& path, const Ground& ground, const MapScale& scale);

}  // namespace scanway::planning
