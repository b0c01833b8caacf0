#pragma once

#include <string>
#include <vector>

#include "common/grid/bounds.h"
#include "common/grid/cost_map.h"

namespace scanway::tools {

/// A problem of a scenario file; cells by column and row, row 0 at the top of the file.
struct ScenarioProblem {
  Cell start;
  Cell goal;
  double optimal_length = 0.0;  ///< In cells: 1 straight, sqrt(2) diagonal, no corner of an obstacle is cut.
};

/// A scenario file of Moving AI's benchmarks (Sturtevant 2012; movingai.com/benchmarks/formats.html) and its map.
struct Scenario {
  CostMap map;  ///< 1 m a cell, row y of the file at y. `.`, `G` and `S` are free, all else is occupied.
  CellRectangle bounds;
  std::vector<ScenarioProblem> problems;
};

/// Reads the .scen at `path` and the map that it names, which must lie beside it. Throws InputError.
Scenario read_scenario(const std::string& path);

}  // namespace scanway::tools
