#pragma once

#include <optional>

#include "modules/mapper/core/registration/keypoints.h"

namespace scanway::registration {

/// Source keypoints and target keypoints that look alike.
struct Match {
  std::uint32_t source;
  std::uint32_t target;
};

/// The pairs each of which is the other's nearest in the space of descriptors. With `R_target_source` (a tracker's
/// rotation) the turned normals take part in the distance, and pairs whose normals then disagree are left out.
/// `mutual` false: the nearest of every keypoint of either side, whether it answers or not; more of the right matches
/// where scans overlap little, and many more wrong ones.
std::vector<Match> match_keypoints(const Keypoints& source, const Keypoints& target,
                                   const std::optional<Eigen::Matrix3f>& R_target_source, bool mutual = true);

}  // namespace scanway::registration
