#pragma once

#include <limits>

#include <Eigen/Core>

#include "modules/planner/core/body/terrain.h"

namespace scanway::planning {

/// The least distance from the body's poses (without a body, from its centre) to the square of an occupied cell.
class Clearance {
 public:
  explicit Clearance(const Terrain& terrain);

  /// One more pose, in cells and radians; returns whether it is the nearest so far.
  bool add(const Eigen::Vector2d& at, double heading);
  /// In cells; infinity when there is no occupied cell.
  double least() const { return least_; }

 private:
  void look(const Eigen::Vector2d& at, double window);
  void hold(const Eigen::Vector2d& at, Cell cell);

  static constexpr double kNone = std::numeric_limits<double>::infinity();
  const Terrain* terrain_;
  bool has_body_;
  double reach_;
  Polygon polygon_;
  double least_ = kNone;
  bool none_ = false;  ///< There is no occupied cell at all.
};

}  // namespace scanway::planning
