#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "common/grid/bounds.h"
#include "common/grid/cost_map.h"
#include "common/random/random.h"

namespace scanway::test {

/// A map and the rectangle of its cells.
struct TestMap {
  CostMap map;
  CellRectangle bounds;

  void fill(CellRectangle cells, CellState state);
};

/// All free.
TestMap free_map(std::int32_t width, std::int32_t height, double resolution_m);

/// Single cells and rectangles of obstacles up to about `share` of the map, and as many unknown ones when asked.
TestMap random_map(std::int32_t width, std::int32_t height, double resolution_m, double share, bool unknown,
                   Random& random);

/// Random costs, up to twice kCostOne, in patches.
void add_random_costs(TestMap& map, Random& random);

Cell random_cell(const CellRectangle& bounds, Random& random);

/// A problem of a Moving AI scenario file.
struct Problem {
  Cell start;
  Cell goal;
  double optimal_length = 0.0;
};

/// Moving AI's grid map `name` of ../shared/data/grid_maps_movingai, 1 m a cell, row 0 at y = 0.
TestMap moving_ai_map(const std::string& name);
std::vector<Problem> moving_ai_problems(const std::string& name);
bool has_moving_ai_maps();

/// A cell's middle, in metres.
Eigen::Vector2d middle_of(const CostMap& map, Cell cell);

}  // namespace scanway::test
