#pragma once

#include <cstdint>
#include <vector>

#include "modules/mapper/core/costmap/occupancy_window.h"

namespace scanway {

/// For each cell of the window the squared distance, in cells, of its centre from that of the nearest occupied cell of
/// the window; (limit + 1)^2 where none is within `limit` cells, 0 < limit < 255. Exact.
/// (Felzenszwalb and Huttenlocher, Distance Transforms of Sampled Functions, 2012: first along columns, then the lower
/// envelope of parabolas along rows.)
std::vector<std::uint32_t> squared_distances(const OccupancyWindow& window, int limit);

}  // namespace scanway
