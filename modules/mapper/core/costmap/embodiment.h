#pragma once

#include <vector>

#include "common/grid/cost_map.h"
#include "common/robot/robot.h"

namespace scanway {

/// Writes the cost of every cell from the occupied cells of the map, whatever costs it had before.
///
/// `paper`: the sum over all occupied cells within 29 cells of exp(-(dx^2 + dy^2) / 2), dx and dy in cells at every
/// resolution (the paper's sigma is one cell, of 1 cm). The kernel is rounded to 2^-24 and summed in integers, so the
/// sum is exact to half a unit an obstacle, the same in any order, and can be undone. Beyond 5.83 cells (dx^2 + dy^2 >
/// 34) the kernel rounds to nothing: the paper's 29 cells add no more. An occupied cell has its cost like any other;
/// what forbids it is its state.
///
/// `footprint`: by the clearance, the distance of the cell's centre from the nearest occupied cell's centre less half
/// a cell's diagonal (so never more than the true distance from the obstacle's edge). Within the inscribed radius:
/// kCostLethal, the body would touch at every heading. Up to the circumscribed radius: kCostOne, whether the body
/// touches depends on the heading. Beyond, kCostOne * (1 - t)^2, t rising evenly from 0 to 1 at three times the
/// circumscribed radius (0.86 m for ERA-Mobi), and 0 from there on. Distances are exact (Euclidean, in whole squared
/// cells).
///
/// Tiles in which nothing is known and nothing costs are removed; tiles that gain a cost are made.
void embody(CostMap& map, const Robot& robot, Embodiment embodiment);

/// The same, where the map was embodied before and since then only states within the tiles `touched` have changed: only
/// what they reach is computed, and the map is the one that the function above makes. Returns every tile that may
/// differ from before: those touched, and those whose costs changed, tiles that were made or removed included; in
/// order.
std::vector<Cell> embody(CostMap& map, const Robot& robot, Embodiment embodiment, const std::vector<Cell>& touched);

}  // namespace scanway
