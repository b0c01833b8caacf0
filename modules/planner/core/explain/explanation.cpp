#include "modules/planner/core/explain/explanation.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <vector>

#include <fmt/format.h>

#include "modules/planner/core/explain/area.h"
#include "modules/planner/core/explain/nearest.h"
#include "modules/planner/core/explain/obstruction.h"

namespace scanway::planning {
namespace {

std::string text_of(const Eigen::Vector2d& at) { return fmt::format("({:.2f}, {:.2f})", at.x(), at.y()); }

/// The least width of a polygon's hull: across the edge or diagonal that has all corners on one side.
double least_width(const Polygon& polygon) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& a : polygon) {
    for (const auto& b : polygon) {
      const Eigen::Vector2d along = b - a;
      if (along.norm() == 0.0) continue;
      double low = 0.0, high = 0.0;
      for (const auto& corner : polygon) {
        const double aside = (along.x() * (corner - a).y() - along.y() * (corner - a).x()) / along.norm();
        low = std::min(low, aside);
        high = std::max(high, aside);
      }
      least = std::min(least, high - low);
    }
  }
  return least;
}

/// Explains one question.
class Explainer {
 public:
  Explainer(Terrain& terrain, const MapScale& scale, const Question& question)
      : terrain_(terrain), scale_(scale), question_(question), area_(terrain.bounds()) {}

  Explanation off_map(const char* end, const Eigen::Vector2d& at) const {
    const CellRectangle& bounds = terrain_.bounds();
    const Eigen::Vector2d half(0.5, 0.5);
    return {fmt::format("the {} {} is off the map, which reaches from {} to {}", end, text_of(at),
                        text_of(scale_.middle_of(bounds.low) - scale_.resolution_m * half),
                        text_of(scale_.middle_of(bounds.high) - scale_.resolution_m * half)),
            at};
  }

  /// The end is where the robot's centre cannot be.
  Explanation bad_end(const std::string& what, const Eigen::Vector2d& at, Cell cell) {
    Explanation why;
    why.at_m = at;
    why.text = what;
    const auto room = nearest(terrain_.bounds(), cell, [this](Cell one) { return has_room(terrain_, one); });
    if (room) why.near_m = scale_.middle_of(*room);
    why.text += room ? fmt::format("; the nearest place where it could be is {}, {:.2f} m away", text_of(*why.near_m),
                                   distance(*room, cell) * scale_.resolution_m)
                     : "; there is no place on this map where it could be";
    return why;
  }

  Explanation unknown_end(const char* end, const Eigen::Vector2d& at, Cell cell) {
    Explanation why = bad_end(
        fmt::format("nobody has seen the {} {}, and unknown cells are never crossed", end, text_of(at)), at, cell);
    why.text += "; with unknown at a price or free it would be no obstacle";
    return why;
  }

  Explanation tight_end(const char* end, const Eigen::Vector2d& at, Cell cell) {
    Explanation why =
        bad_end(fmt::format("this body does not fit at the {} {} at any heading", end, text_of(at)), at, cell);
    const auto blocks = [this](Cell one) { return terrain_.blocks(one); };
    const CellRectangle& bounds = terrain_.bounds();
    const CellRectangle beyond = {{bounds.low.x - 1, bounds.low.y - 1}, {bounds.high.x + 1, bounds.high.y + 1}};
    const auto nearest_one = nearest(beyond, cell, blocks);
    why.needed_m = terrain_.body().inscribed() * scale_.resolution_m;
    if (!nearest_one) return why;
    why.blocked_m = std::max(0.0, distance(*nearest_one, cell) - 0.5) * scale_.resolution_m;
    why.text += fmt::format("; what blocks is {:.2f} m from its centre, and it reaches {:.2f} m to its nearest side",
                            *why.blocked_m, *why.needed_m);
    return why;
  }

  Explanation walled_in() const {
    std::size_t cells = 0;
    Cell best = *question_.start;
    const auto nearness = [this](Cell cell) { return std::tuple(distance(cell, *question_.goal), cell.y, cell.x); };
    const auto is_wall = [this](Cell cell) { return this->is_wall(cell); };
    for_reached(area_, *question_.start, is_wall, [&](Cell cell) {
      ++cells;
      if (nearness(cell) < nearness(best)) best = cell;
      return true;
    });
    Explanation why;
    why.near_m = scale_.middle_of(best);
    why.reached_m2 = static_cast<double>(cells) * scale_.resolution_m * scale_.resolution_m;
    why.text = fmt::format(
        "obstacles part the start from the goal: they leave {:.2f} m2 around the start, nearest to the goal at {}, "
        "{:.2f} m from it",
        *why.reached_m2, text_of(*why.near_m), distance(best, *question_.goal) * scale_.resolution_m);
    return why;
  }

  /// By the way with the fewest unknown cells.
  Explanation only_through_unknown() const {
    const std::vector<Reached> reached = fewest_unknown();
    Cell entry = *question_.goal;
    for (Cell cell = *question_.goal; cell != *question_.start;) {
      const auto step = static_cast<std::size_t>(reached[area_.index(cell)].step);
      if (terrain_.is_unknown(cell)) entry = cell;
      cell = {cell.x - kStepX[step], cell.y - kStepY[step]};
    }
    Explanation why;
    why.at_m = scale_.middle_of(entry);
    why.unknown_m = reached[area_.index(*question_.goal)].unknown * scale_.resolution_m;
    why.text = fmt::format(
        "every way leads through cells that nobody has seen, and they are never crossed: the way with the fewest of "
        "them enters them at {} and has {:.2f} m of them; with unknown at a price or free there is one",
        text_of(*why.at_m), *why.unknown_m);
    return why;
  }

  Explanation too_narrow() const {
    const Obstruction obstruction = find_obstruction(terrain_, *question_.start, *question_.goal);
    Explanation why;
    why.at_m = scale_.middle_of(obstruction.narrowest);
    why.width_m = obstruction.width_cells * scale_.resolution_m;
    why.needed_m = least_width(terrain_.body().footprint()) * scale_.resolution_m;
    why.turning_m = 2.0 * terrain_.body().circumscribed() * scale_.resolution_m;
    why.text = fmt::format(
        "of all ways the one that keeps furthest from what blocks is narrowest at {}: {:.2f} m; this body needs {:.2f} "
        "m to pass straight on and {:.2f} m to turn",
        text_of(*why.at_m), *why.width_m, *why.needed_m, *why.turning_m);
    return why;
  }

 private:
  /// How a cell is reached from the start with the fewest unknown cells on the way.
  struct Reached {
    std::uint32_t unknown = std::numeric_limits<std::uint32_t>::max();
    int step = 0;  ///< That leads here.
  };

  std::vector<Reached> fewest_unknown() const {
    std::vector<Reached> reached(area_.size());
    std::deque<Cell> queue = {*question_.start};
    reached[area_.index(*question_.start)].unknown = 0;
    while (!queue.empty()) {
      const Cell cell = queue.front();
      queue.pop_front();
      const std::uint32_t so_far = reached[area_.index(cell)].unknown;
      for (int step = 0; step < kSteps; ++step) {
        const auto next = step_from(cell, step, [this](Cell one) { return is_wall(one); });
        if (!next) continue;
        const bool counts = terrain_.is_unknown(*next);
        const Reached now = {so_far + (counts ? 1 : 0), step};
        if (now.unknown >= reached[area_.index(*next)].unknown) continue;
        reached[area_.index(*next)] = now;
        queue.insert(counts ? queue.end() : queue.begin(), *next);
      }
    }
    return reached;
  }

  bool is_wall(Cell cell) const { return !area_.contains(cell) || terrain_.is_occupied(cell); }

  Terrain& terrain_;
  const MapScale& scale_;
  const Question& question_;
  Area area_;
};

}  // namespace

bool has_room(Terrain& terrain, Cell cell) {
  const std::uint32_t index = terrain.frame().index(cell);
  const Terrain::Class what = Terrain::class_of(terrain.field(index));
  if (what == Terrain::Class::tight) return terrain.headings(terrain.slot(index)) != 0;
  return what == Terrain::Class::roomy;
}

Explanation explain(Terrain& terrain, const MapScale& scale, PlanStatus status, const Question& question) {
  Explainer why(terrain, scale, question);
  const auto in_obstacle = [&](const char* end, const Eigen::Vector2d& at, Cell cell) {
    return why.bad_end(fmt::format("the {} {} is in an obstacle", end, text_of(at)), at, cell);
  };
  switch (status) {
    case PlanStatus::start_off_map:
      return why.off_map("start", question.start_m);
    case PlanStatus::goal_off_map:
      return why.off_map("goal", question.goal_m);
    case PlanStatus::start_in_obstacle:
      return in_obstacle("start", question.start_m, *question.start);
    case PlanStatus::goal_in_obstacle:
      return in_obstacle("goal", question.goal_m, *question.goal);
    case PlanStatus::start_unknown:
      return why.unknown_end("start", question.start_m, *question.start);
    case PlanStatus::goal_unknown:
      return why.unknown_end("goal", question.goal_m, *question.goal);
    case PlanStatus::start_too_tight:
      return why.tight_end("start", question.start_m, *question.start);
    case PlanStatus::goal_too_tight:
      return why.tight_end("goal", question.goal_m, *question.goal);
    case PlanStatus::walled_in:
      return why.walled_in();
    case PlanStatus::only_through_unknown:
      return why.only_through_unknown();
    case PlanStatus::too_narrow:
      return why.too_narrow();
    default:
      return {};
  }
}

}  // namespace scanway::planning
