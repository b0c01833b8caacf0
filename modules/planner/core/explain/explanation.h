#pragma once

#include <optional>
#include <string>

#include <Eigen/Core>

#include "modules/planner/core/body/terrain.h"
#include "modules/planner/core/explain/plan_status.h"
#include "modules/planner/core/path/map_scale.h"

namespace scanway::planning {

/// Why there is no path, and what would help; metres in `map`. What does not apply is left out.
struct Explanation {
  std::string text = {};                       ///< All of it in words.
  std::optional<Eigen::Vector2d> at_m = {};    ///< Where the trouble is.
  std::optional<double> width_m = {};          ///< How wide it is there,
  std::optional<double> needed_m = {};         ///< and how wide it must be for this body to pass straight on,
  std::optional<double> turning_m = {};        ///< or to turn.
  std::optional<double> blocked_m = {};        ///< How near to `at_m` the nearest cell that blocks is.
  std::optional<Eigen::Vector2d> near_m = {};  ///< The nearest place to it that would do, or that can be reached.
  std::optional<double> reached_m2 = {};       ///< The area that obstacles leave around the start.
  std::optional<double> unknown_m = {};        ///< How much unknown the way with the least of it crosses.
};

/// What a plan was asked.
struct Question {
  Eigen::Vector2d start_m, goal_m;
  std::optional<Cell> start, goal;  ///< Nothing where that is off the map.
};

/// For any status but no_map and ok.
Explanation explain(Terrain& terrain, const MapScale& scale, PlanStatus status, const Question& question);

/// Whether the body can stand in a cell, at some heading.
bool has_room(Terrain& terrain, Cell cell);

}  // namespace scanway::planning
