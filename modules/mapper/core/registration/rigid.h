#pragma once

#include <span>

#include "common/geometry/pose.h"

namespace scanway::registration {

struct PointPair {
  Eigen::Vector3d source;
  Eigen::Vector3d target;
  double weight = 1.0;
};

/// The rigid transform T that minimises the sum of weight * |T source - target|^2, by SVD: Umeyama, Least-squares
/// estimation of transformation parameters between two point patterns, PAMI 1991 (without scale). At least three pairs
/// that are not on one line determine it; for fewer it is one of the best.
Pose rigid_from_pairs(std::span<const PointPair> pairs);

}  // namespace scanway::registration
