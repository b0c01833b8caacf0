#pragma once

#include <cstdint>

namespace scanway {

/// Which sweep of a map: the greater, the newer.
using SweepNumber = std::uint64_t;

}  // namespace scanway
