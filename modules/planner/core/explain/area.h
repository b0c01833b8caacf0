#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "common/grid/bounds.h"
#include "modules/planner/core/body/body.h"

namespace scanway::planning {

/// The cells of a rectangle, row by row.
class Area {
 public:
  explicit Area(const CellRectangle& bounds) : bounds_(bounds) {}
  std::size_t size() const { return static_cast<std::size_t>(bounds_.width() * bounds_.height()); }
  std::size_t index(Cell cell) const {
    return static_cast<std::size_t>((cell.y - bounds_.low.y) * bounds_.width() + (cell.x - bounds_.low.x));
  }
  Cell cell(std::size_t index) const {
    const auto width = static_cast<std::size_t>(bounds_.width());
    return {bounds_.low.x + static_cast<std::int32_t>(index % width),
            bounds_.low.y + static_cast<std::int32_t>(index / width)};
  }
  bool contains(Cell cell) const { return bounds_.contains(cell); }
  const CellRectangle& bounds() const { return bounds_; }

 private:
  CellRectangle bounds_;
};

/// The neighbour at `step`, if the step crosses no corner of a cell that `blocks`.
template <class Blocks>
std::optional<Cell> step_from(Cell cell, int step, const Blocks& blocks) {
  const auto at = static_cast<std::size_t>(step);
  const Cell next = {cell.x + kStepX[at], cell.y + kStepY[at]};
  if (blocks(next)) return std::nullopt;
  if ((step & 1) != 0 && (blocks({next.x, cell.y}) || blocks({cell.x, next.y}))) return std::nullopt;
  return next;
}

/// Calls visit(cell) for all that can be reached from `start`, it included, until it returns false.
template <class Blocks, class Visit>
void for_reached(const Area& area, Cell start, const Blocks& blocks, Visit&& visit) {
  std::vector<bool> seen(area.size());
  std::vector<Cell> stack = {start};
  seen[area.index(start)] = true;
  while (!stack.empty()) {
    const Cell cell = stack.back();
    stack.pop_back();
    if (!visit(cell)) return;
    for (int step = 0; step < kSteps; ++step) {
      const auto next = step_from(cell, step, blocks);
      if (!next || seen[area.index(*next)]) continue;
      seen[area.index(*next)] = true;
      stack.push_back(*next);
    }
  }
}

}  // namespace scanway::planning
