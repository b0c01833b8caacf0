#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "modules/mapper/core/map.h"
#include "tests/modules/mapper/core/costmap/scene.h"

namespace scanway::testing {
namespace {

constexpr double kCell = 0.01;
constexpr int kSeam = 2;  // cells: what the contract leaves open around an edge
constexpr double kBody = 1.5;
const Eigen::Vector3d kSensor(0.3, -0.2, 1.4);

/// How the cells of a map compare with the truth, seams left out.
struct Comparison {
  int obstacle_cells = 0, obstacle_free = 0;
  int seen_cells = 0, seen_unknown = 0, seen_occupied = 0;
  int hidden_cells = 0, hidden_free = 0;
  std::string first_wrong;
};

bool is_obstacle(const Scene& scene, Cell cell) {
  // the slab that is climbed is ground, not an obstacle
  return scene.blocks(cell.x * kCell, cell.y * kCell, kCell, 0.02, kBody);
}

bool near_edge(const Scene& scene, Cell cell) {
  const double x = (cell.x - kSeam) * kCell, y = (cell.y - kSeam) * kCell, side = (2 * kSeam + 1) * kCell;
  return scene.blocks(x, y, side, 0.02, kBody) && !is_obstacle(scene, cell);
}

bool deep_inside(const Scene& scene, Cell cell) {
  for (int dy = -kSeam; dy <= kSeam; dy += kSeam) {
    for (int dx = -kSeam; dx <= kSeam; dx += kSeam) {
      if (!is_obstacle(scene, {cell.x + dx, cell.y + dy})) return false;
    }
  }
  return true;
}

/// Share of the air column over the cell, from the ground to the body's height, that the sensor sees.
double seen_share(const Scene& scene, const std::vector<Eigen::Vector3d>& sensors, Cell cell) {
  double best = 0.0;
  const double x = (cell.x + 0.5) * kCell, y = (cell.y + 0.5) * kCell;
  const bool on_slab = scene.blocks(cell.x * kCell, cell.y * kCell, kCell, 0.0, 0.02);
  for (const Eigen::Vector3d& sensor : sensors) {
    int seen = 0;
    constexpr int kHeights = 16;
    for (int i = 0; i < kHeights; ++i) {
      const double z = (on_slab ? 0.021 : 0.001) + i * (kBody - 0.021) / (kHeights - 1);
      seen += scene.visible(sensor, {x, y, z}) ? 1 : 0;
    }
    best = std::max(best, static_cast<double>(seen) / kHeights);
  }
  return best;
}

/// The least and the greatest share within the seam: an edge of a shadow is an edge, too.
std::pair<double, double> seen_shares(const Scene& scene, const std::vector<Eigen::Vector3d>& sensors, Cell cell) {
  double least = 1.0, greatest = 0.0;
  for (int dy = -kSeam; dy <= kSeam; dy += kSeam) {
    for (int dx = -kSeam; dx <= kSeam; dx += kSeam) {
      const double share = seen_share(scene, sensors, {cell.x + dx, cell.y + dy});
      least = std::min(least, share);
      greatest = std::max(greatest, share);
    }
  }
  return {least, greatest};
}

void judge_free(const Scene& scene, const std::vector<Eigen::Vector3d>& sensors, const CostMap& map, Cell cell,
                Comparison& result) {
  const CellState state = map.state(cell);
  const double here = seen_share(scene, sensors, cell);
  const bool seen = here == 1.0, hidden = here == 0.0;
  const bool wrong_if_seen = state != CellState::free, wrong_if_hidden = state == CellState::free;
  result.seen_cells += seen ? 1 : 0;
  result.hidden_cells += hidden ? 1 : 0;
  if (!(seen && wrong_if_seen) && !(hidden && wrong_if_hidden)) return;
  const auto [least, greatest] = seen_shares(scene, sensors, cell);
  if (seen ? least < 1.0 : greatest > 0.0) return;
  result.seen_unknown += seen && state == CellState::unknown ? 1 : 0;
  result.seen_occupied += seen && state == CellState::occupied ? 1 : 0;
  result.hidden_free += hidden ? 1 : 0;
  if (result.first_wrong.empty()) {
    result.first_wrong = (seen ? "seen floor not free at " : "hidden floor free at ") +
                         std::to_string((cell.x + 0.5) * kCell) + ", " + std::to_string((cell.y + 0.5) * kCell);
  }
}

Comparison compare(const Scene& scene, const std::vector<Eigen::Vector3d>& sensors, const CostMap& map) {
  Comparison result;
  for (std::int32_t y = -250; y < 250; ++y) {
    for (std::int32_t x = -300; x < 500; ++x) {
      const Cell cell{x, y};
      if (is_obstacle(scene, cell)) {
        if (!deep_inside(scene, cell)) continue;
        ++result.obstacle_cells;
        if (map.state(cell) == CellState::free) {
          ++result.obstacle_free;
          if (result.first_wrong.empty()) {
            result.first_wrong = "obstacle free at " + std::to_string(x * kCell) + ", " + std::to_string(y * kCell);
          }
        }
      } else if (!near_edge(scene, cell)) {
        judge_free(scene, sensors, map, cell, result);
      }
    }
  }
  return result;
}

CostMap map_of(const std::vector<Sweep>& sweeps) {
  Map map(Robot{}, 1);
  for (const Sweep& sweep : sweeps) map.merge(sweep, Pose::Identity());
  return map.cost_map();
}

TEST(Room, OneSweepWithoutNoiseIsRightButForTheSeams) {
  const Scene scene = furnished_room();
  const Comparison c = compare(scene, {kSensor}, map_of({scan(scene, kSensor, 0.12, 0.1667, 0.0, 1)}));
  EXPECT_EQ(c.obstacle_free, 0) << c.first_wrong << " of " << c.obstacle_cells;
  EXPECT_EQ(c.seen_unknown, 0) << c.first_wrong << " of " << c.seen_cells;
  EXPECT_EQ(c.seen_occupied, 0) << c.first_wrong << " of " << c.seen_cells;
  EXPECT_EQ(c.hidden_free, 0) << c.first_wrong << " of " << c.hidden_cells;
  EXPECT_GT(c.obstacle_cells, 10000);
  EXPECT_GT(c.seen_cells, 100000);
  EXPECT_GT(c.hidden_cells, 10000);
}

TEST(Room, RangeNoiseCostsAFewCellsOfFloorAndOpensNoObstacle) {
  const Scene scene = furnished_room();
  const Comparison c = compare(scene, {kSensor}, map_of({scan(scene, kSensor, 0.12, 0.1667, 0.01, 7)}));
  EXPECT_EQ(c.obstacle_free, 0) << c.first_wrong << " of " << c.obstacle_cells;
  EXPECT_EQ(c.hidden_free, 0) << c.first_wrong << " of " << c.hidden_cells;
  EXPECT_LE(c.seen_unknown, c.seen_cells / 100) << c.first_wrong << " of " << c.seen_cells;
  EXPECT_LE(c.seen_occupied, c.seen_cells / 1000) << c.first_wrong << " of " << c.seen_cells;
}

}  // namespace
}  // namespace scanway::testing
