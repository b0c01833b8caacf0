#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "common/grid/bounds.h"
#include "common/grid/cost_map.h"
#include "common/progress/stages.h"
#include "common/robot/robot.h"
#include "modules/planner/core/body/terrain.h"
#include "modules/planner/core/explain/explanation.h"
#include "modules/planner/core/explain/plan_status.h"
#include "modules/planner/core/path/ground.h"
#include "modules/planner/core/path/path_pose.h"
#include "modules/planner/core/search/route_finder.h"

namespace scanway::planning {

/// How a path is told.
enum class PathForm {
  cells,   ///< From cell to cell, as the search found it.
  smooth,  ///< Straightened and its corners rounded; never dearer, and as clear as the body needs.
};

/// A path, or why there is none.
struct PlanResult {
  PlanStatus status = PlanStatus::no_map;
  /// "ok", or the reason in words, with the place where there is one.
  std::string reason;
  /// In driving order. Two poses in the same place are a turn in place, the shorter way round; from place to place the
  /// robot drives straight, or turning evenly in a bend. Against its heading it drives backwards.
  std::vector<PathPose> path;
  UnknownPolicy unknown = UnknownPolicy::never;  ///< What the plan may do with unknown cells.
  double length_m = 0.0;
  /// Of the way on cells: its length, each metre at its weight (docs/planning.md); what the search has made least.
  double cost = 0.0;
  double worst_cost = 0.0;  ///< What a metre costs where the path is dearest.
  /// From the footprint on its way (in modes point and paper: from the robot's centre) to the nearest point of an
  /// occupied cell; infinity when there is none.
  double clearance_m = 0.0;
  Eigen::Vector2d clearance_at_m = Eigen::Vector2d::Zero();  ///< The robot's place there.
  double unknown_share = 0.0;                                ///< Of the length, through cells nobody has seen.
  Effort effort;
};

/// Plans on a cost map for a body, again and again: maps grow and change, the robot moves, goals move. What earlier
/// plans found is used for the next one and changes nothing in its cost.
class Planner {
 public:
  /// Without a `form`: smooth for the footprint, and cells for the paper's two paths, which are what it compares.
  Planner(const Robot& robot, BodyMode mode, std::optional<PathForm> form = std::nullopt);

  /// The map from now on, in place of any earlier one. `bounds` is where the robot's centre may be; without it, all
  /// tiles of the map. The map is copied in a form of its own. Throws std::length_error for more than 3 * 2^30 cells.
  void set_map(const CostMap& map, std::optional<CellRectangle> bounds = std::nullopt);
  /// These tiles (by tile index) have appeared, changed or gone. The map's resolution and origin are as before.
  void update(const CostMap& map, const std::vector<Cell>& tiles);
  /// Start and goal in metres in `map`. `stages` hears of `search`, `smooth` and `measure`.
  PlanResult plan(const Eigen::Vector2d& start_m, const Eigen::Vector2d& goal_m, StageListener* stages = nullptr);
  /// Why such a plan came out as it did, with what is in its way. Takes longer than the plan.
  Explanation explain(const PlanResult& result, const Eigen::Vector2d& start_m, const Eigen::Vector2d& goal_m);

 private:
  void rebuild(const CostMap& map);
  std::optional<Cell> cell_at(const Eigen::Vector2d& point_m) const;
  PlanStatus check(std::optional<Cell> start, std::optional<Cell> goal);
  void name_obstruction(PlanResult& result, Cell start, Cell goal) const;
  void trace(const Route& route, PlanResult& result, StageListener* stages);
  std::vector<PathPose> smoothed(const Route& route, const Ground& ground) const;

  Robot robot_;
  TerrainOptions options_;
  PathForm form_;
  std::optional<CellRectangle> given_bounds_;
  double resolution_m_ = 0.0;
  Eigen::Vector2d origin_m_ = Eigen::Vector2d::Zero();
  std::unique_ptr<Body> body_;
  std::unique_ptr<Terrain> terrain_;
  std::unique_ptr<RouteFinder> finder_;
};

}  // namespace scanway::planning
