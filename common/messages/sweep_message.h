#pragma once

#include "common/cloud/sweep.h"
#include "scanway/sweep_t.hpp"

namespace scanway {

/// The orientation travels on IMU, not here.
sweep_t to_message(const Sweep& sweep);
/// Without orientation. Throws BadMessage when it contradicts itself.
Sweep to_sweep(const sweep_t& message);

}  // namespace scanway
