#pragma once

#include <Eigen/Geometry>

#include "bot_core/ins_t.hpp"
#include "common/time/utime.h"

namespace scanway {

/// Only the orientation is known: the rest is NaN, device_time 0.
bot_core::ins_t imu_message(Utime utime, const Eigen::Quaterniond& R_world_body);
/// R_world_body. Throws BadMessage unless it is a rotation.
Eigen::Quaterniond orientation_of(const bot_core::ins_t& message);

}  // namespace scanway
