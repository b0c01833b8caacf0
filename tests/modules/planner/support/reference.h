#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "common/robot/robot.h"
#include "modules/planner/core/body/terrain.h"
#include "tests/modules/planner/support/maps.h"

namespace scanway::test {

/// What a metre costs in a cell, by docs/planning.md.
double weight_of(const TestMap& map, const Robot& robot, planning::BodyMode mode, Cell cell);

/// The least cost between two cells by a plain Dijkstra on cells, in metres; nothing when there is no way. The rules of
/// docs/planning.md for the modes point and paper, written without the planner's code.
std::optional<double> dijkstra_cost(const TestMap& map, const Robot& robot, planning::BodyMode mode, Cell start,
                                    Cell goal);

/// The same for the mode footprint, on all (x, y, 16 headings), with polygons tested against every blocked cell.
/// `headings` = 8 leaves out the odd ones.
std::optional<double> dijkstra_cost_of_body(const TestMap& map, const Robot& robot, Cell start, Cell goal,
                                            int headings);

}  // namespace scanway::test
