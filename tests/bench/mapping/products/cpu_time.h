#pragma once

#include <algorithm>
#include <ctime>
#include <vector>

namespace scanway::bench {

inline double cpu_s() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// The median of CPU seconds of so many runs.
template <class Work>
double median_cpu_s(int runs, const Work& work) {
  std::vector<double> seconds;
  for (int i = 0; i < runs; ++i) {
    const double before = cpu_s();
    work();
    seconds.push_back(cpu_s() - before);
  }
  std::sort(seconds.begin(), seconds.end());
  return seconds[seconds.size() / 2];
}

}  // namespace scanway::bench
