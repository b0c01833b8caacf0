#pragma once

#include "bot_core/pose_t.hpp"
#include "common/geometry/pose.h"
#include "common/time/utime.h"

namespace scanway {

/// X: the pose of the body in the channel's frame. The motion is zero: the robot stands while it scans.
bot_core::pose_t pose_message(Utime utime, const Pose& X);
/// Throws BadMessage unless it is a rigid pose.
Pose pose_of(const bot_core::pose_t& message);

}  // namespace scanway
