#include "tests/bench/mapping/products/embodiments.h"

#include <cmath>
#include <cstdio>
#include <vector>

#include "common/math/repeatable.h"
#include "common/random/random.h"
#include "modules/mapper/core/costmap/embodiment.h"
#include "tests/bench/mapping/products/cpu_time.h"

namespace scanway::bench {
namespace {

constexpr int kCells = 4000;
constexpr int kReach = 29;
constexpr int kWidth = kCells + 2 * kReach;

CostMap scattered() {
  CostMap map;
  Random random(1);
  for (int y = 0; y < kCells; ++y) {
    for (int x = 0; x < kCells; ++x)
      map.set_state({x, y}, random.below(20) == 0 ? CellState::occupied : CellState::free);
  }
  return map;
}

/// The textbook's way: the kernel's table added around every obstacle.
class DirectTable {
 public:
  DirectTable() {
    for (int dy = -kReach; dy <= kReach; ++dy) {
      for (int dx = -kReach; dx <= kReach; ++dx) {
        const double value = dx * dx + dy * dy > kReach * kReach ? 0.0 : repeatable::exp(-0.5 * (dx * dx + dy * dy));
        table_.push_back(static_cast<std::uint32_t>(std::floor(value * kCostOne + 0.5)));
      }
    }
  }

  void scatter(const std::vector<Cell>& obstacles) {
    costs_.assign(static_cast<std::size_t>(kWidth) * kWidth, 0);
    for (const Cell& obstacle : obstacles) {
      for (int r = 0; r <= 2 * kReach; ++r) {
        std::uint32_t* to = &costs_[static_cast<std::size_t>(obstacle.y + r) * kWidth + obstacle.x];
        const std::uint32_t* from = &table_[static_cast<std::size_t>(r) * (2 * kReach + 1)];
        for (int i = 0; i <= 2 * kReach; ++i) to[i] += from[i];
      }
    }
  }
  std::uint32_t at(int x, int y) const { return costs_[static_cast<std::size_t>(y + kReach) * kWidth + x + kReach]; }

 private:
  std::vector<std::uint32_t> table_, costs_;
};

bool same(const DirectTable& direct, const CostMap& map) {
  for (int y = 0; y < kCells; ++y) {
    for (int x = 0; x < kCells; ++x) {
      if (direct.at(x, y) != map.cost({x, y})) return false;
    }
  }
  return true;
}

double one_tile_s(CostMap& map, Embodiment mode) {
  Random random(2);
  return median_cpu_s(21, [&] {
    const Cell tile{1 + static_cast<std::int32_t>(random.below(28)), 1 + static_cast<std::int32_t>(random.below(28))};
    for (int i = 0; i < 800; ++i) {
      map.set_state({tile.x * CostTile::kSide + static_cast<std::int32_t>(random.below(CostTile::kSide)),
                     tile.y * CostTile::kSide + static_cast<std::int32_t>(random.below(CostTile::kSide))},
                    random.below(2) == 0 ? CellState::occupied : CellState::free);
    }
    embody(map, Robot{}, mode, {tile});
  });
}

}  // namespace

void compare_embodiments() {
  CostMap map = scattered();
  std::vector<Cell> obstacles;
  for (int y = 0; y < kCells; ++y) {
    for (int x = 0; x < kCells; ++x) {
      if (map.state({x, y}) == CellState::occupied) obstacles.push_back({x, y});
    }
  }
  DirectTable table;
  const double direct = median_cpu_s(3, [&] { table.scatter(obstacles); });
  const double paper = median_cpu_s(5, [&] { embody(map, Robot{}, Embodiment::paper); });
  const bool equal = same(table, map);
  const double paper_tile = one_tile_s(map, Embodiment::paper);
  const double footprint = median_cpu_s(3, [&] { embody(map, Robot{}, Embodiment::footprint); });
  const double footprint_tile = one_tile_s(map, Embodiment::footprint);
  std::puts("| embodiment of 4000 x 4000 cells | whole, CPU ms | one tile changed, CPU ms |\n|---|---|---|");
  std::printf("| direct table, 59 x 59 | %.0f | |\n", 1e3 * direct);
  std::printf("| paper (%s) | %.1f | %.2f |\n", equal ? "the same costs" : "OTHER COSTS", 1e3 * paper,
              1e3 * paper_tile);
  std::printf("| footprint | %.0f | %.1f |\n", 1e3 * footprint, 1e3 * footprint_tile);
}

}  // namespace scanway::bench
