#pragma once

#include "modules/mapper/core/registration/icp.h"
#include "modules/mapper/core/registration/prepared_scan.h"

namespace scanway::registration {

/// The last, exact step, and how far to trust it.
struct LastStep {
  Pose T_target_source = Pose::Identity();
  /// Of [rotation vector, translation] as in IcpResult: what the planes' own scatter gives, and the jackknife over
  /// parts of the scene on top of it. Parts that contradict each other make it large.
  Matrix6 covariance = Matrix6::Identity();
  double rmse_m = 0.0;  ///< Of the distances of the source's surfaces from the target's planes, weighted.
  std::size_t matches = 0;
  double moved_m = 0.0;  ///< From the pose that it began at.
};

/// Deviation of the translation in its least known direction, and of the rotation.
double sigma_m(const Matrix6& covariance);
double sigma_rad(const Matrix6& covariance);

/// From a pose that is right to some centimetres: every chosen surface of the source against the plane through the
/// target's points (0.1 m voxels) within the same distance of the same place. Both are then means over the same piece
/// of the scene, so its roughness and curvature cancel, and no normal is carried sideways as in point-to-plane ICP.
/// Each pair counts by the variance of its two planes.
///
/// The jackknife leaves out one part of the scene at a time (cubes of some metres, dealt to kParts groups): Tukey 1958;
/// Efron, The Jackknife, the Bootstrap and Other Resampling Plans, 1982, chapter 3.
LastStep take_last_step(const PreparedScan::Data& source, const PreparedScan::Data& target,
                        const Pose& T_target_source);

}  // namespace scanway::registration
