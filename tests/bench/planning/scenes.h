#pragma once

#include <cstdint>
#include <vector>

#include "common/grid/cost_map.h"
#include "modules/planner/core/body/terrain.h"
#include "tests/bench/planning/textbook.h"

namespace scanway::bench {

/// A square map of cells of 1 m.
struct Scene {
  const char* name;
  planning::BodyMode mode;
  CostMap map;
  std::int32_t side;
};

/// Single cells, a fifth of all.
Scene rubble(std::int32_t side);
/// Rooms of 80 cells; three of four walls have a door of 4 cells.
Scene rooms(std::int32_t side);
/// No obstacle; costs change smoothly between 0 and kCostOne.
Scene weighted(std::int32_t side);

/// A twentieth of these cells becomes an obstacle. Returns the tiles that they are in.
std::vector<Cell> scatter(Scene& scene, Cell low, Cell high);
/// These cells, where they are on the map, get a state. Returns the tiles that they are in.
std::vector<Cell> fill(Scene& scene, Cell low, Cell high, CellState state);

/// The same prices as docs/planning.md has them.
PlainMap plain(const Scene& scene);

}  // namespace scanway::bench
