#pragma once

#include <optional>

#include "common/geometry/pose.h"
#include "modules/mapper/core/registration/matching.h"

namespace scanway::registration {

/// How far the true rotation may lie from the one that the tracker gives.
struct RotationBounds {
  Eigen::Matrix3d R_target_source = Eigen::Matrix3d::Identity();
  double heading = 0.26;  ///< Radians.
  double tilt = 0.1;
};

/// Whether R lies within the bounds: its heading difference, and the angle between the two verticals.
bool within(const RotationBounds& bounds, const Eigen::Matrix3d& R_target_source);

/// A pose that a set of matches agrees on.
struct Hypothesis {
  Pose T_target_source = Pose::Identity();
  std::size_t votes = 0;  ///< Matches within the tolerance.
};

struct ConsensusOptions {
  double tolerance_m = 0.5;     ///< Of a match at the right pose: some two voxels of the keypoints.
  double min_baseline_m = 1.5;  ///< Nearer pairs of matches say nothing of the rotation.
  std::size_t max_matches = 1500;
  std::size_t max_seeds = 800;
  std::size_t max_hypotheses = 16;
  double distinct_m = 0.7;  ///< Nearer hypotheses (and of like rotation) are one.
  double distinct_angle = 0.12;
};

/// The poses on which matches agree, most votes first. Two matches are compatible if lengths and the angles of normals
/// agree, and (with bounds) the turned difference vectors too; the seeds of a pose are matches that share many
/// compatible others (second-order consistency: Chen et al., SC2-PCR, CVPR 2022), its pose the SVD of its group.
std::vector<Hypothesis> find_hypotheses(const Keypoints& source, const Keypoints& target,
                                        const std::vector<Match>& matches, const std::optional<RotationBounds>& bounds,
                                        const ConsensusOptions& options);

}  // namespace scanway::registration
