#pragma once

#include <cstdint>

namespace scanway {

/// UDP datagrams that the kernel has thrown away on this machine because a receive buffer was full.
std::int64_t kernel_drops();

}  // namespace scanway
