#include "modules/mapper/core/costmap/embodiment.h"

#include <cmath>
#include <cstdint>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "common/random/random.h"
#include "modules/mapper/core/costmap/distance_field.h"

namespace scanway {
namespace {

/// Scattered obstacles around the borders of tiles, where mistakes would be.
CostMap scattered(int obstacles, int extent, std::uint64_t seed) {
  Random random(seed);
  CostMap map;
  const auto coordinate = [&] { return static_cast<std::int32_t>(random.below(2 * extent)) - extent; };
  for (int i = 0; i < obstacles; ++i) map.set_state({coordinate(), coordinate()}, CellState::occupied);
  for (int i = 0; i < 50; ++i) {
    const Cell cell{coordinate(), coordinate()};
    if (map.state(cell) == CellState::unknown) map.set_state(cell, CellState::free);
  }
  return map;
}

std::vector<Cell> obstacles_of(const CostMap& map) {
  std::vector<Cell> cells;
  for (const auto& [index, tile] : map.tiles) {
    for (std::size_t i = 0; i < CostTile::kCells; ++i) {
      if (tile.state[i] != CellState::occupied) continue;
      cells.push_back({index.x * CostTile::kSide + static_cast<std::int32_t>(i % CostTile::kSide),
                       index.y * CostTile::kSide + static_cast<std::int32_t>(i / CostTile::kSide)});
    }
  }
  return cells;
}

TEST(PaperEmbodiment, IsTheSumOfThePapersFormulaToTheStatedBound) {
  CostMap map = scattered(400, 160, 2);
  // a dense patch over four tiles, for sums of many terms
  for (std::int32_t y = -8; y < 8; ++y) {
    for (std::int32_t x = -8; x < 8; ++x) map.set_state({x, y}, CellState::occupied);
  }
  embody(map, Robot{}, Embodiment::paper);
  const std::vector<Cell> obstacles = obstacles_of(map);
  double worst = 0.0;
  for (std::int32_t y = -200; y < 200; y += 1) {
    for (std::int32_t x = -200; x < 200; x += 3) {
      double expected = 0.0;
      int terms = 0;
      for (const Cell& o : obstacles) {
        const double squared = std::pow(x - o.x, 2) + std::pow(y - o.y, 2);
        if (squared > 29.0 * 29.0) continue;
        expected += std::exp(-squared / 2.0);
        ++terms;
      }
      const double error = std::fabs(map.cost({x, y}) - expected * kCostOne);
      EXPECT_LE(error, 0.5 * terms + 1e-3) << x << " " << y;
      worst = std::max(worst, expected);
    }
  }
  EXPECT_GT(worst, 6.0) << "the scene has cells in the midst of obstacles";
}

TEST(PaperEmbodiment, OneObstacleCostsOneAtItself) {
  CostMap map;
  map.set_state({127, 127}, CellState::occupied);
  embody(map, Robot{}, Embodiment::paper);
  EXPECT_EQ(map.cost({127, 127}), kCostOne);
  EXPECT_EQ(map.cost({128, 127}), map.cost({126, 127}));
  EXPECT_EQ(map.cost({128, 128}), map.cost({126, 126}));
  EXPECT_EQ(map.cost({127 + 6, 127}), 0u);
  EXPECT_EQ(map.cost({127 + 5, 127 + 3}), 1u);
  EXPECT_EQ(map.tiles.size(), 4u);
}

TEST(FootprintEmbodiment, ByTheDistanceFromTheNearestObstacle) {
  const Robot robot;
  for (const double resolution : {0.01, 0.05}) {
    CostMap map = scattered(60, 300, 5);
    map.resolution_m = resolution;
    embody(map, robot, Embodiment::footprint);
    const std::vector<Cell> obstacles = obstacles_of(map);
    Random random(1);
    for (int i = 0; i < 3000; ++i) {
      const Cell cell{static_cast<std::int32_t>(random.below(800)) - 400,
                      static_cast<std::int32_t>(random.below(800)) - 400};
      double nearest = 1e9;
      for (const Cell& o : obstacles) nearest = std::min(nearest, std::hypot(cell.x - o.x, cell.y - o.y));
      const double clearance = (nearest - std::sqrt(0.5)) * resolution;
      const std::uint32_t cost = map.cost(cell);
      if (clearance < robot.inscribed_radius_m() - 1e-9) {
        EXPECT_EQ(cost, kCostLethal);
      } else if (clearance <= robot.circumscribed_radius_m() - 1e-9) {
        EXPECT_EQ(cost, kCostOne);
      } else {
        const double t = (clearance - robot.circumscribed_radius_m()) / (2.0 * robot.circumscribed_radius_m());
        EXPECT_NEAR(cost, t < 1.0 ? std::pow(1.0 - t, 2) * kCostOne : 0.0, 1.0);
      }
    }
  }
}

TEST(Embodiment, LeavesNoTraceOfObstaclesThatWent) {
  CostMap with = scattered(100, 200, 7), without = with;
  const Robot robot;
  for (const Embodiment mode : {Embodiment::paper, Embodiment::footprint}) {
    for (std::int32_t i = 0; i < 50; ++i) with.set_state({300 + i, 500}, CellState::occupied);
    embody(with, robot, mode);
    for (std::int32_t i = 0; i < 50; ++i) with.set_state({300 + i, 500}, CellState::unknown);
    embody(with, robot, mode);
    embody(without, robot, mode);
    EXPECT_EQ(with.tiles, without.tiles);
  }
}

/// Cells of some tiles become occupied, free or unknown; the tiles.
std::vector<Cell> change_somewhere(CostMap& map, Random& random) {
  std::vector<Cell> touched;
  for (std::uint64_t i = random.below(3) + 1; i > 0; --i) {
    const Cell tile{static_cast<std::int32_t>(random.below(9)) - 4, static_cast<std::int32_t>(random.below(9)) - 4};
    const bool clear = random.below(3) == 0;
    for (int k = 0; k < (clear ? CostTile::kSide * CostTile::kSide : 40); ++k) {
      const Cell cell{tile.x * CostTile::kSide + (clear ? k % CostTile::kSide : std::int32_t(random.below(128))),
                      tile.y * CostTile::kSide + (clear ? k / CostTile::kSide : std::int32_t(random.below(128)))};
      map.set_state(cell, clear ? CellState::unknown : static_cast<CellState>(random.below(3)));
    }
    touched.push_back(tile);
  }
  return touched;
}

TEST(Embodiment, WhereAChangeReachesIsTheSameAsAnew) {
  for (const Embodiment mode : {Embodiment::paper, Embodiment::footprint}) {
    CostMap map = scattered(80, 400, 11);
    embody(map, Robot{}, mode);
    Random random(17);
    for (int round = 0; round < 15; ++round) {
      const CostMap before = map;
      const std::vector<Cell> touched = change_somewhere(map, random);
      CostMap anew = map;
      const std::vector<Cell> changed = embody(map, Robot{}, mode, touched);
      embody(anew, Robot{}, mode);
      ASSERT_TRUE(map.tiles == anew.tiles) << "round " << round;
      const std::set<Cell> told(changed.begin(), changed.end());
      for (const auto& [index, tile] : map.tiles) {
        const auto old = before.tiles.find(index);
        EXPECT_TRUE(told.contains(index) || (old != before.tiles.end() && old->second == tile));
      }
      for (const auto& [index, tile] : before.tiles) {
        EXPECT_TRUE(told.contains(index) || map.tiles.contains(index));
      }
    }
  }
}

TEST(Embodiment, AnEmptyMapStaysEmpty) {
  CostMap map;
  embody(map, Robot{}, Embodiment::paper);
  embody(map, Robot{}, Embodiment::footprint);
  EXPECT_TRUE(map.tiles.empty());
}

TEST(DistanceField, IsExact) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    Random random(seed);
    OccupancyWindow window{
        {0, 0}, 40 + static_cast<int>(random.below(60)), 30 + static_cast<int>(random.below(60)), {}, true};
    window.occupied.assign(static_cast<std::size_t>(window.width) * window.height, 0);
    for (std::uint64_t i = 0; i < seed * 2; ++i) window.occupied[random.below(window.occupied.size())] = 1;
    constexpr int kLimit = 25;
    const std::vector<std::uint32_t> field = squared_distances(window, kLimit);
    for (int y = 0; y < window.height; ++y) {
      for (int x = 0; x < window.width; ++x) {
        int best = (kLimit + 1) * (kLimit + 1);
        for (int v = 0; v < window.height; ++v) {
          for (int u = 0; u < window.width; ++u) {
            const int squared = (x - u) * (x - u) + (y - v) * (y - v);
            if (window.occupied[static_cast<std::size_t>(v) * window.width + u] != 0 && squared <= kLimit * kLimit) {
              best = std::min(best, squared);
            }
          }
        }
        ASSERT_EQ(field[static_cast<std::size_t>(y) * window.width + x], static_cast<std::uint32_t>(best));
      }
    }
  }
}

}  // namespace
}  // namespace scanway
