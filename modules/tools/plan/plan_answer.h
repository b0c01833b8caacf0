#pragma once

#include <optional>
#include <string>

#include <nlohmann/json.hpp>

#include "modules/planner/core/planner.h"

namespace scanway::tools {

/// What `scanway plan` says: as JSON, as a line for people, and as a table of the poses.

nlohmann::ordered_json json_of(const planning::PlanResult& result);
nlohmann::ordered_json json_of(const planning::Explanation& why);
std::string text_of(const planning::PlanResult& result);
std::string csv_of(const planning::PlanResult& result);
const char* name_of(UnknownPolicy policy);

}  // namespace scanway::tools
