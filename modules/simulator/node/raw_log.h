#pragma once

#include "common/bus/bus.h"
#include "modules/simulator/node/raw_messages.h"

namespace scanway::simulator {

/// Publishes a sweep to `bus` as the bridges of a robot would, in the order in which they would: the tracker at 100 Hz
/// and the pan-tilt at 50 Hz, from a second before the sweep to half a second after it, the marks of its start and end,
/// the lines each when its last beam is measured.
void publish_raw_sweep(Bus& bus, const RawSweep& raw, const Tracker& tracker, const SweepNumbers& numbers);

}  // namespace scanway::simulator
