#pragma once

#include <vector>

#include "modules/mapper/core/costmap/evidence.h"
#include "modules/mapper/core/costmap/obstacle_returns.h"
#include "modules/mapper/core/ground/soft_ground.h"

namespace scanway {

/// Vegetation::pass: returns up to GroundPatches::kGrass_m over soft ground are from blades that give way. A stone as
/// low that hides in them is left out, too; what is higher stays.
void leave_out_grass(std::vector<ObstacleReturn>& obstacles, const SoftGround& soft);

/// Vegetation::avoid: soft ground that was seen is occupied, but not within the robot's circumscribed radius of where
/// it stands.
void occupy_soft_ground(SweepEvidence& evidence, const SoftGround& soft, const Robot& robot, const Pose& X_map_sweep);

}  // namespace scanway
