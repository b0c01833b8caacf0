#pragma once

#include <string>

namespace scanway::bench {

/// Two sweeps of a world, 10 m apart, as binary PCD in the sensor's frame, and their truth: `folder`/source.pcd,
/// target.pcd, pair.txt. The pan turns `slower` than the robot's, for as many more lines.
void write_whole_pair(const std::string& folder, const std::string& world, double distance_m, double slower);

/// From those files to the verdict on one thread and on two, `runs` times each in turn, a process of its own each time:
/// prints wall and CPU seconds by stage, the peak of memory above what the two clouds take, the error; at the end the
/// medians and how many times faster two threads are.
void run_whole_pair(const std::string& folder, int runs);

}  // namespace scanway::bench
