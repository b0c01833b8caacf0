#pragma once

#include <ctime>

namespace scanway::bench {

/// CPU milliseconds of this process while `work` runs.
template <class Work>
double cpu_ms(Work&& work) {
  const std::clock_t begin = std::clock();
  work();
  return 1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

}  // namespace scanway::bench
