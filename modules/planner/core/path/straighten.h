#pragma once

#include <vector>

#include "modules/planner/core/path/ground.h"
#include "modules/planner/core/search/route_finder.h"

namespace scanway::planning {

/// The legs of a route, a step each.
std::vector<Leg> legs_of(const Route& route, const Ground& ground);

/// The same way with straight legs at any angle from cell to cell of it, where the body passes and no leg costs more
/// than what it replaces. The cost of all never rises.
std::vector<Leg> straightened(std::vector<Leg> legs, const Ground& ground);

}  // namespace scanway::planning
