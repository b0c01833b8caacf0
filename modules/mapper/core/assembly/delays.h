#pragma once

#include <vector>

#include "modules/mapper/core/assembly/scan_line.h"

namespace scanway {

/// The pan's angles as they were at the times beside them. The pan-tilt tells no time, so a state has that of its
/// arrival, and is late by whatever kept the machine busy: 5 ms are 0.015 degrees of a survey's turn, and 0.3 degrees
/// of one that is twenty times as fast. No state is early, and a pan that turns evenly is a clock by itself: the states
/// around say when it must have been at each angle. Where it does not turn evenly (it speeds up or brakes, is stuck,
/// stands) states stay as they were told. `angles` by rising time, no two at the same.
std::vector<PanTiltAngles> without_delays(std::vector<PanTiltAngles> angles, Utime longest_gap_us);

}  // namespace scanway
