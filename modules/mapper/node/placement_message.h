#pragma once

#include "common/cloud/sweep.h"
#include "common/geometry/pose.h"
#include "modules/mapper/core/mapper.h"
#include "scanway/registration_t.hpp"

namespace scanway {

/// What became of a sweep, for REGISTRATION.
registration_t registration_message(const SweepResult& result);

/// Where the robot stands, for POSE: below the sensor, on the ground that the sweep found, else in the sweep's own
/// origin.
Pose base_pose(const SweepResult& result, const Sweep& sweep);

}  // namespace scanway
