#pragma once

#include <Eigen/Core>

#include "common/time/utime.h"
#include "scanway/goal_t.hpp"

namespace scanway {

/// In the map frame, metres.
goal_t goal_message(Utime utime, const Eigen::Vector2d& goal);
/// Throws BadMessage unless it is finite.
Eigen::Vector2d goal_of(const goal_t& message);

}  // namespace scanway
