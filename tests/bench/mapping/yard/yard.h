#pragma once

#include <cstdint>

#include "modules/mapper/core/cloud/map_points.h"

namespace scanway::bench {

/// A panoramic sweep of a walled yard, 40 m a side: uneven ground, crates and poles. `steps_round` headings times
/// `steps_up` elevations, millimetres of noise, from a place that depends on `number`; the yard is always the same.
MapPoints yard_sweep(int number, int steps_round, int steps_up);

/// The steps of a sweep of 3.4 million points.
constexpr int kFullRound = 2400;
constexpr int kFullUp = 1420;

/// The same of a site of 100 m x 60 m behind walls of 4 m (over them a beam meets nothing), which the robot drives in
/// five lanes to and fro, with ten stops in each.
constexpr double kSiteLane_m = 11.0;
constexpr int kSiteStops = 10;
MapPoints site_sweep(int number, int steps_round, int steps_up);

}  // namespace scanway::bench
