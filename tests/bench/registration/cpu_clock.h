#pragma once

#include <ctime>

namespace scanway::bench {

/// CPU seconds of this process, over all of its threads.
inline double cpu_s() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

}  // namespace scanway::bench
