#pragma once

namespace scanway::bench {

/// Prints a table: a full sweep of the yard into one point a voxel, ours and PCL's, CPU seconds on one thread.
void compare_voxel_grids();

}  // namespace scanway::bench
