#pragma once

#include <cstdint>
#include <vector>

#include "common/messages/layout.h"
#include "common/random/random.h"

namespace scanway::test {

/// The bytes of a random message of that layout, with edge values among its numbers and lengths of 0 to `max_length`.
std::vector<std::uint8_t> random_wire(const Layout& layout, Random& random, std::int64_t max_length);

}  // namespace scanway::test
