#pragma once

#include "bot_core/joint_state_t.hpp"
#include "modules/mapper/core/assembly/line_collector.h"
#include "modules/mapper/core/assembly/scan_line.h"
#include "scanway/laser_line_t.hpp"

namespace scanway {

/// Throws BadMessage for numbers that no line has.
LinePiece piece_of(const laser_line_t& message);
/// Of the joints `pan` and `tilt`. Throws BadMessage without them.
PanTiltAngles angles_of(const bot_core::joint_state_t& message);

}  // namespace scanway
