#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "common/grid/cost_map.h"
#include "common/robot/robot.h"
#include "modules/simulator/core/world/world.h"

namespace scanway::simulator {

/// What a cell is in truth.
enum class CellTruth : std::uint8_t {
  unknown = 0,   ///< No ground.
  free = 1,      ///< Ground that the body can be over.
  occupied = 2,  ///< A surface, or the inside of a body, between the climbable step and the body's height above it.
  drop_off = 3,  ///< The upper edge of a fall of more than kDropOff_m.
};

constexpr double kDropOff_m = 0.10;

/// The world as a grid of cells, from its geometry; no scan is involved. Cell (0, 0) is that of the window's low
/// corner; cells lie on whole multiples of the resolution from the world's origin.
struct TruthGrid {
  double resolution_m = 0.01;
  Cell low;  ///< The index of the first cell, counted from the world's origin.
  std::int32_t width = 0, height = 0;
  std::vector<CellTruth> cells;  ///< Row by row from the lowest y.

  CellTruth at(Cell cell) const;  ///< By its index from the world's origin; unknown outside.
  CellTruth at(double x, double y) const;
};

/// What of `body` counts: climbable step and height. `window`: the part of the world, all of it by default. The local
/// ground of a cell is the ground under its centre; neighbours whose ground is higher by more than the climbable step
/// make a cell occupied, those whose ground is lower by more than kDropOff_m make it a drop-off.
TruthGrid make_truth(const World& world, const Robot::Body& body, double resolution_m = 0.01,
                     std::optional<Rectangle> window = std::nullopt);

/// As a map that one can plan on: drop-offs are occupied. `only_drop_offs`: drop-offs are occupied, all else is free.
CostMap to_cost_map(const TruthGrid& truth, bool only_drop_offs = false);

}  // namespace scanway::simulator
