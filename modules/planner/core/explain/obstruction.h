#pragma once

#include <optional>

#include "common/grid/cost_map.h"
#include "modules/planner/core/body/terrain.h"

namespace scanway::planning {

/// Why there is no way between two cells that do not block themselves.
struct Obstruction {
  enum class Kind { walled_in, only_through_unknown, too_narrow } kind;
  Cell narrowest;            ///< For too_narrow: where the widest way is narrowest,
  double width_cells = 0.0;  ///< and how wide it is there.
};

Obstruction find_obstruction(const Terrain& terrain, Cell start, Cell goal);

}  // namespace scanway::planning
