#pragma once

#include <vector>

#include <Eigen/Core>

#include "modules/planner/core/planner.h"

namespace scanway::planning {

/// From cells of the map's frame to metres.
struct MapScale {
  double resolution_m;
  Eigen::Vector2d origin_m;
  Eigen::Vector2d middle_of(Cell cell) const {
    return origin_m + resolution_m * Eigen::Vector2d(cell.x + 0.5, cell.y + 0.5);
  }
  Eigen::Vector2d to_cells(double x_m, double y_m) const {
    return (Eigen::Vector2d(x_m, y_m) - origin_m) / resolution_m - Eigen::Vector2d(0.5, 0.5);
  }
};

/// The poses along a route: at each cell the heading of the step that led there, then that of the step that leads on.
std::vector<PathPose> poses_of(const Route& route, const MapScale& scale);

/// Fills in length, unknown share and clearance of result.path.
void measure(PlanResult& result, const Terrain& terrain, const MapScale& scale);

}  // namespace scanway::planning
