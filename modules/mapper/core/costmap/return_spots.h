#pragma once

#include <Eigen/Core>

#include "modules/mapper/core/costmap/evidence.h"
#include "modules/mapper/core/costmap/obstacle_returns.h"

namespace scanway {

/// An obstacle's return comes from anywhere in its beam's spot: half of the divergence times the range. Cells of a spot
/// that hold no return themselves and were seen to be free are not known to be: they become EvidenceTile::kUnsure.
/// `sensor`: in the map.
void doubt_spots(SweepEvidence& evidence, const Eigen::Vector3d& sensor, const SweepViewConfig& config,
                 double resolution_m);

}  // namespace scanway
