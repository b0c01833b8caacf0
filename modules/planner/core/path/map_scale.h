#pragma once

#include <Eigen/Core>

#include "common/grid/cost_map.h"

namespace scanway::planning {

/// From cells of the map's frame to metres.
struct MapScale {
  double resolution_m;
  Eigen::Vector2d origin_m;
  Eigen::Vector2d middle_of(Cell cell) const { return to_metres({cell.x, cell.y}); }
  Eigen::Vector2d to_metres(const Eigen::Vector2d& cells) const {
    return origin_m + resolution_m * (cells + Eigen::Vector2d(0.5, 0.5));
  }
  Eigen::Vector2d to_cells(double x_m, double y_m) const {
    return (Eigen::Vector2d(x_m, y_m) - origin_m) / resolution_m - Eigen::Vector2d(0.5, 0.5);
  }
};

}  // namespace scanway::planning
