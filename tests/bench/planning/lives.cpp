#include "tests/bench/planning/lives.h"

#include "modules/planner/core/planner.h"
#include "tests/bench/planning/cpu_time.h"

namespace scanway::bench {
namespace {

using planning::Planner;
using planning::PlanResult;

CellRectangle bounds_of(const Scene& scene) { return {{0, 0}, {scene.side, scene.side}}; }

Eigen::Vector2d middle(Cell cell) { return {cell.x + 0.5, cell.y + 0.5}; }

Cell cell_at(const Eigen::Vector2d& point) { return {static_cast<int>(point.x()), static_cast<int>(point.y())}; }

/// The point so far along a path, or its end.
Eigen::Vector2d along(const PlanResult& plan, double distance) {
  for (std::size_t i = 1; i < plan.path.size(); ++i) {
    const Eigen::Vector2d from(plan.path[i - 1].x_m, plan.path[i - 1].y_m);
    const Eigen::Vector2d to(plan.path[i].x_m, plan.path[i].y_m);
    const double length = (to - from).norm();
    if (length >= distance) return from + (to - from) * (length > 0.0 ? distance / length : 0.0);
    distance -= length;
  }
  return {plan.path.back().x_m, plan.path.back().y_m};
}

/// One planner that stays, beside new ones.
class Beside {
 public:
  Beside(const Scene& scene, int every) : scene_(scene), every_(every), kept_(Robot(), scene.mode) {
    kept_.set_map(scene.map, bounds_of(scene));
  }

  PlanResult first(Cell start, Cell goal) { return kept_.plan(middle(start), middle(goal)); }

  PlanResult next(const std::vector<Cell>& changed, Cell start, Cell goal) {
    PlanResult plan;
    life_.kept_ms += cpu_ms([&] {
      if (!changed.empty()) kept_.update(scene_.map, changed);
      plan = kept_.plan(middle(start), middle(goal));
    });
    if (life_.plans++ % every_ == 0) compare(plan, start, goal);
    return plan;
  }
  const Life& life() const { return life_; }

 private:
  void compare(const PlanResult& plan, Cell start, Cell goal) {
    Planner fresh(Robot(), scene_.mode);
    fresh.set_map(scene_.map, bounds_of(scene_));
    PlanResult anew;
    life_.anew_ms += every_ * cpu_ms([&] { anew = fresh.plan(middle(start), middle(goal)); });
    if (anew.status != plan.status || anew.cost != plan.cost) ++life_.differ;
  }

  const Scene& scene_;
  int every_;
  Planner kept_;
  Life life_;
};

}  // namespace

Life drive(Scene scene, int every) {
  Beside planners(scene, every);
  const Cell goal = {scene.side - 1, scene.side - 1};
  PlanResult plan = planners.first({0, 0}, goal);
  Cell block = {-9, -9};
  for (int driven = 20; driven <= 4000; driven += 20) {
    const Cell start = cell_at(along(plan, 20.0));
    std::vector<Cell> tiles = fill(scene, block, {block.x + 5, block.y + 5}, CellState::free);
    const Cell ahead = cell_at(along(plan, 35.0 + driven % 3 * 5.0));
    block = {ahead.x - 2, ahead.y - 2};
    for (const Cell& tile : fill(scene, block, {block.x + 5, block.y + 5}, CellState::occupied)) tiles.push_back(tile);
    plan = planners.next(tiles, start, goal);
    if (plan.path.empty()) break;
  }
  return planners.life();
}

Life follow(const Scene& scene, int every) {
  Beside planners(scene, every);
  Cell goal = {scene.side - 1, scene.side - 1};
  planners.first({0, 0}, goal);
  for (int move = 1; move <= 100; ++move) {
    goal = {scene.side - 1 - 10 * move, scene.side - 1};
    while (scene.map.state(goal) != CellState::free) --goal.y;
    planners.next({}, {0, 0}, goal);
  }
  return planners.life();
}

Life change_near_goal(Scene scene) {
  Beside planners(scene, 1);
  const Cell goal = {scene.side - 1, scene.side - 1};
  planners.first({0, 0}, goal);
  const std::vector<Cell> tiles =
      scatter(scene, {scene.side - 220, scene.side - 220}, {scene.side - 20, scene.side - 20});
  planners.next(tiles, {0, 0}, goal);
  return planners.life();
}

}  // namespace scanway::bench
