#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "common/clock/steady_time.h"
#include "modules/tools/spy/traffic.h"

namespace scanway::tools {

/// A line a channel, and below the table why messages were bad.
std::string traffic_table(const Traffic& traffic, SteadyTime now);

nlohmann::ordered_json traffic_json(const Traffic& traffic, SteadyTime now);

}  // namespace scanway::tools
