#pragma once

#include "bot_core/joint_state_t.hpp"
#include "modules/mapper/core/assembly/assembly.h"
#include "modules/mapper/core/assembly/line_collector.h"
#include "modules/mapper/core/assembly/scan_line.h"
#include "modules/mapper/node/raw_channel.h"
#include "scanway/laser_line_t.hpp"

namespace scanway {

/// Throws BadMessage for numbers that no line has.
LinePiece piece_of(const laser_line_t& message);
/// Of the joints `pan` and `tilt`. Throws BadMessage without them.
PanTiltAngles angles_of(const bot_core::joint_state_t& message);

/// What the messages of a sweep hold: LASER_LINE, PAN_TILT_STATE and IMU.
AssemblyInput assembly_input(const RawChannel::Messages& lines, const RawChannel::Messages& angles,
                             const RawChannel::Messages& imu);

}  // namespace scanway
