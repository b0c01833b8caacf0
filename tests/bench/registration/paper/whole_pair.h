#pragma once

#include <string>

namespace scanway::bench {

/// Two full sweeps of a world, 10 m apart, as binary PCD in the sensor's frame, and their truth: `folder`/source.pcd,
/// target.pcd, pair.txt.
void write_whole_pair(const std::string& folder, const std::string& world, double distance_m);

/// From those files to the verdict with this many threads, one line: wall and CPU seconds, the peak of memory above
/// what the two clouds take, the error. A process of its own each time, or the peak is that of the run before.
void run_whole_pair(const std::string& folder, int threads);

}  // namespace scanway::bench
