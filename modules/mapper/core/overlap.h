#pragma once

#include <cstddef>
#include <vector>

#include "modules/mapper/core/locate.h"

namespace scanway {

/// The sweeps of the map, those first that were taken nearest to where its newest one was, at most `count`: where the
/// robot may be when nothing else says so. Of equals the newer one. None that is withdrawn, here and below.
std::vector<std::size_t> nearest_to_last(const std::vector<PlacedSweep>& map, std::size_t count);

/// The sweeps of the map that share enough with `sweep`, were it at that pose: those with the largest share first, at
/// most `count`. Of equals the newer one.
std::vector<std::size_t> most_overlapping(const PlacedSweep& sweep, const Pose& X_map_sweep,
                                          const std::vector<PlacedSweep>& map, std::size_t count);

}  // namespace scanway
