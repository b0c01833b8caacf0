#pragma once

#include <cstdint>
#include <string>

#include "modules/simulator/core/world/world.h"

namespace scanway::tools {

/// The world that --world and --seed name. Throws InputError, which names the worlds there are.
simulator::World world_of(const std::string& name, std::uint64_t seed);

}  // namespace scanway::tools
