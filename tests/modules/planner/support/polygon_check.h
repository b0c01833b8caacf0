#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "common/robot/robot.h"
#include "modules/planner/core/path/path_pose.h"
#include "tests/modules/planner/support/maps.h"

namespace scanway::test {

/// Tests convex footprints against every cell that blocks (occupied, or unknown under `never`), by separating axes,
/// without the planner's code.
class PolygonCheck {
 public:
  /// Outside map.bounds all is unknown.
  PolygonCheck(const TestMap& map, const Robot& robot);

  bool blocks(Cell cell) const;
  /// Whether the footprint's area and that of a blocking cell overlap by more than rounding. `at` in cells: the middle
  /// of cell (x, y) is (x, y).
  bool hits(const Eigen::Vector2d& at, double heading) const;
  bool hits_at(double x_m, double y_m, double heading) const;
  /// The first pose of a path, or between two of its poses, that hits, in words; empty: none does. From pose to pose
  /// the body moves and turns evenly, the shorter way round, and is looked at whenever a point of it has moved half a
  /// cell.
  std::string first_hit(const std::vector<planning::PathPose>& path) const;

 private:
  CellRectangle bounds_;
  double resolution_m_;
  Eigen::Vector2d origin_m_;
  bool unknown_blocks_;
  double reach_ = 0.0;
  std::vector<Eigen::Vector2d> footprint_;  ///< In cells.
  std::vector<char> blocked_;
};

}  // namespace scanway::test
