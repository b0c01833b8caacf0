#pragma once

#include <cstdint>
#include <string>

#include "common/time/utime.h"
#include "modules/schunk_bridge/core/pan_tilt.h"
#include "scanway/pan_tilt_command_t.hpp"

namespace scanway::schunk {

/// "MOVE"
std::string command_name(std::int8_t command);

/// Hands a command to the pan-tilt; what it leaves open is as `configured`. Returns why it is refused, or nothing.
std::string carry_out(const pan_tilt_command_t& command, PanTilt& pan_tilt, const SweepConfig& configured, Utime now);

}  // namespace scanway::schunk
