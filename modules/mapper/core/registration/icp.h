#pragma once

#include <span>

#include "common/geometry/pose.h"
#include "modules/mapper/core/registration/cell_grid.h"
#include "modules/mapper/core/registration/surfaces.h"

namespace scanway::registration {

using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

/// What the source is registered to: pieces of surface and a neighbour index over their centres.
struct IcpTarget {
  const Surfaces& surfaces;
  const CellGrid& grid;  ///< Over surfaces.centre.
};

/// One round of the coarse-to-fine schedule.
struct IcpRound {
  float max_distance_m;  ///< Of a correspondence.
  float kernel_m;        ///< Scale of the robust kernel: residuals beyond it count ever less.
  int iterations;
  bool tighten = false;  ///< The kernel shrinks to three deviations of the residuals before, 3 cm at least.
};

struct IcpResult {
  Pose T_target_source = Pose::Identity();
  /// Of the last iteration: the weighted normal equations' matrix for [rotation vector, translation] of a small motion
  /// of the source in the target's frame, rotation about the source's sensor; its weights sum to `weight`.
  Matrix6 information = Matrix6::Zero();
  double weight = 0.0;
  /// The same without the balance of directions: rare directions are noise as often as structure, and must not pass for
  /// knowledge of where the scene holds the pose.
  Matrix6 plain_information = Matrix6::Zero();
  double plain_weight = 0.0;
  double rmse_m = 0.0;      ///< Of the point-to-plane distances, weighted.
  double lever_m = 1.0;     ///< Root mean square distance of the inliers from the source's sensor.
  std::size_t inliers = 0;  ///< Correspondences of the last iteration.
};

/// Point-to-plane ICP between chosen surfaces (Chen and Medioni 1992; normals of both sides as in Rusinkiewicz, A
/// Symmetric Objective Function for ICP, 2019), with a Geman-McClure kernel.
///
/// Composition: a step (w, v) turns the source about its sensor and then shifts it, in the target's frame:
/// R_ref = exp(w) R, T_ref = T + v. The paper writes R_ref = R R_ICP, T_ref = T + T_ICP; that is the same if its R_ICP
/// is our exp(w) expressed in the source's frame, R_ICP = R^T exp(w) R, and its T_ICP is expressed in the target's.
/// With an ICP that returns a transform K = [R_K, T_K] of the already moved cloud about the target's origin, as most
/// do, it is not: then R_ref = R_K R and T_ref = R_K T + T_K.
IcpResult run_icp(const Surfaces& source, const IcpTarget& target, const Pose& T_target_source,
                  std::span<const IcpRound> rounds);

}  // namespace scanway::registration
