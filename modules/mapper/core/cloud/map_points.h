#pragma once

#include <vector>

#include <Eigen/Core>

#include "common/cloud/sweep.h"
#include "common/geometry/pose.h"

namespace scanway {

/// The usable points of one sweep, in the map frame.
struct MapPoints {
  std::vector<Eigen::Vector3f> points;
  std::vector<float> intensity;                      ///< Empty, or one a point.
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< The sensor's centre in the map frame, metres.
};

/// X * p, each coordinate ((m0 x + m1 y) + m2 z) + m3 in double: one order of operations for every product.
Eigen::Vector3d transform_in_order(const Pose& X, const Eigen::Vector3d& p);

/// The points of `sweep` that are finite and min_range_m .. max_range_m from its sensor, each coordinate transformed in
/// double and rounded once to float.
MapPoints points_in_map(const Sweep& sweep, const Pose& X_map_sweep, double min_range_m, double max_range_m);

}  // namespace scanway
