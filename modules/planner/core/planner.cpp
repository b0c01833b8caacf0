#include "modules/planner/core/planner.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "modules/planner/core/explain/obstruction.h"
#include "modules/planner/core/path/drive.h"
#include "modules/planner/core/path/map_scale.h"
#include "modules/planner/core/path/measure.h"
#include "modules/planner/core/path/poses.h"
#include "modules/planner/core/path/straighten.h"

namespace scanway::planning {
namespace {

/// All cells of the map's tiles.
CellRectangle extent_of(const CostMap& map) {
  CellRectangle all = {map.tiles.begin()->first, map.tiles.begin()->first};
  for (const auto& entry : map.tiles) {
    const Cell& tile = entry.first;
    all.low = {std::min(all.low.x, tile.x), std::min(all.low.y, tile.y)};
    all.high = {std::max(all.high.x, tile.x), std::max(all.high.y, tile.y)};
  }
  return {{all.low.x * CostTile::kSide, all.low.y * CostTile::kSide},
          {(all.high.x + 1) * CostTile::kSide, (all.high.y + 1) * CostTile::kSide}};
}

}  // namespace

Planner::Planner(const Robot& robot, BodyMode mode, std::optional<PathForm> form)
    : robot_(robot), form_(form.value_or(mode == BodyMode::footprint ? PathForm::smooth : PathForm::cells)) {
  options_.mode = mode;
  options_.unknown = robot.planning.unknown;
  options_.unknown_price = robot.planning.unknown_price;
  options_.clearance_weight = robot.planning.clearance_weight;
}

void Planner::set_map(const CostMap& map, std::optional<CellRectangle> bounds) {
  given_bounds_ = bounds;
  rebuild(map);
}

void Planner::rebuild(const CostMap& map) {
  finder_.reset();
  terrain_.reset();
  if (map.tiles.empty()) return;
  if (!body_ || resolution_m_ != map.resolution_m)
    body_ = std::make_unique<Body>(robot_.body.footprint, map.resolution_m);
  resolution_m_ = map.resolution_m;
  origin_m_ = {map.origin_x_m, map.origin_y_m};
  terrain_ = std::make_unique<Terrain>(map, given_bounds_.value_or(extent_of(map)), *body_, options_);
  finder_ = std::make_unique<RouteFinder>(*terrain_);
}

void Planner::update(const CostMap& map, const std::vector<Cell>& tiles) {
  const bool fits =
      terrain_ && std::all_of(tiles.begin(), tiles.end(), [this](Cell tile) { return terrain_->holds_tile(tile); });
  if (!fits) return rebuild(map);
  if (!given_bounds_ && !map.tiles.empty() && !terrain_->grow(extent_of(map))) return rebuild(map);
  finder_->change(terrain_->update(map, tiles));
}

std::optional<Cell> Planner::cell_at(const Eigen::Vector2d& point_m) const {
  const Eigen::Vector2d at = (point_m - origin_m_) / resolution_m_;
  const CellRectangle& bounds = terrain_->bounds();
  if (!(at.x() >= bounds.low.x && at.y() >= bounds.low.y && at.x() < bounds.high.x && at.y() < bounds.high.y)) {
    return std::nullopt;
  }
  return Cell{static_cast<std::int32_t>(std::floor(at.x())), static_cast<std::int32_t>(std::floor(at.y()))};
}

PlanStatus Planner::check(std::optional<Cell> start, std::optional<Cell> goal) {
  if (!start) return PlanStatus::start_off_map;
  if (!goal) return PlanStatus::goal_off_map;
  if (terrain_->is_occupied(*start)) return PlanStatus::start_in_obstacle;
  if (terrain_->is_occupied(*goal)) return PlanStatus::goal_in_obstacle;
  if (terrain_->blocks(*start)) return PlanStatus::start_unknown;
  if (terrain_->blocks(*goal)) return PlanStatus::goal_unknown;
  if (!has_room(*terrain_, *start)) return PlanStatus::start_too_tight;
  if (!has_room(*terrain_, *goal)) return PlanStatus::goal_too_tight;
  return PlanStatus::ok;
}

void Planner::name_obstruction(PlanResult& result, Cell start, Cell goal) const {
  const Obstruction why = find_obstruction(*terrain_, start, goal);
  if (why.kind == Obstruction::Kind::walled_in) result.status = PlanStatus::walled_in;
  if (why.kind == Obstruction::Kind::only_through_unknown) result.status = PlanStatus::only_through_unknown;
  if (why.kind != Obstruction::Kind::too_narrow) return;
  result.status = PlanStatus::too_narrow;
  const Eigen::Vector2d at = MapScale{resolution_m_, origin_m_}.middle_of(why.narrowest);
  result.reason = fmt::format("{} at ({:.2f}, {:.2f}): {:.2f} m wide there", words_of(result.status), at.x(), at.y(),
                              why.width_cells * resolution_m_);
}

std::vector<PathPose> Planner::smoothed(const Route& route, const Ground& ground) const {
  const MapScale scale = {resolution_m_, origin_m_};
  std::vector<Leg> legs = legs_of(route, ground);
  if (form_ == PathForm::smooth) legs = straightened(std::move(legs), ground);
  const double rounding = form_ == PathForm::smooth ? widest_bend(robot_.body) / resolution_m_ : 0.0;
  std::vector<PathPose> path;
  for (const CellPose& pose : poses_of(legs, ground, rounding)) {
    const Eigen::Vector2d at = scale.to_metres(pose.at);
    path.push_back({at.x(), at.y(), pose.heading});
  }
  if (path.empty()) {
    const Eigen::Vector2d at = scale.middle_of(route.places.front().cell);
    path.push_back({at.x(), at.y(), angle_of(route.places.front().heading.value_or(0))});
  }
  return path;
}

void Planner::trace(const Route& route, PlanResult& result, StageListener* stages) {
  const Ground ground(*terrain_);
  begin_stage(stages, "smooth");
  result.path = driven(smoothed(route, ground), robot_.body);
  begin_stage(stages, "measure");
  const PathMeasures measures = measures_of(result.path, ground, {resolution_m_, origin_m_});
  result.length_m = measures.length_m;
  result.worst_cost = measures.worst_cost;
  result.clearance_m = measures.clearance_m;
  result.clearance_at_m = measures.clearance_at_m;
  result.unknown_share = measures.unknown_share;
}

PlanResult Planner::plan(const Eigen::Vector2d& start_m, const Eigen::Vector2d& goal_m, StageListener* stages) {
  begin_stage(stages, "search");
  PlanResult result;
  result.unknown = options_.unknown;
  result.reason = words_of(result.status);
  if (!terrain_) return result;
  const std::optional<Cell> start = cell_at(start_m);
  const std::optional<Cell> goal = cell_at(goal_m);
  result.status = check(start, goal);
  if (result.status == PlanStatus::ok) {
    const std::optional<Route> route = finder_->find(*start, *goal);
    result.effort = finder_->take_effort();
    if (route) {
      result.cost = route->cost_cells * resolution_m_;
      trace(*route, result, stages);
    } else {
      name_obstruction(result, *start, *goal);
    }
  }
  if (result.reason.empty() || result.status != PlanStatus::too_narrow) result.reason = words_of(result.status);
  return result;
}

Explanation Planner::explain(const PlanResult& result, const Eigen::Vector2d& start_m, const Eigen::Vector2d& goal_m) {
  if (result.status == PlanStatus::no_map) return {.text = "the map has no known cell"};
  if (result.status != PlanStatus::ok) {
    const Question question = {start_m, goal_m, cell_at(start_m), cell_at(goal_m)};
    return planning::explain(*terrain_, {resolution_m_, origin_m_}, result.status, question);
  }
  if (!std::isfinite(result.clearance_m)) return {.text = "there is a path, and no obstacle anywhere"};
  Explanation why{.text = {}, .at_m = result.clearance_at_m, .blocked_m = result.clearance_m};
  why.text = fmt::format("there is a path; it comes nearest to an obstacle at ({:.2f}, {:.2f}): {:.2f} m",
                         why.at_m->x(), why.at_m->y(), *why.blocked_m);
  return why;
}

}  // namespace scanway::planning
