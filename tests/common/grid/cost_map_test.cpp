#include "common/grid/cost_map.h"

#include <algorithm>
#include <limits>
#include <map>

#include <gtest/gtest.h>

#include "common/grid/bounds.h"
#include "common/random/random.h"

namespace scanway {
namespace {

TEST(CostMap, IsAPlainMapOfCells) {
  Random random(1);
  CostMap map;
  std::map<Cell, CellState> states;
  std::map<Cell, std::uint32_t> costs;
  const auto draw = [&] { return static_cast<std::int32_t>(random.below(600)) - 300; };
  for (int i = 0; i < 20000; ++i) {
    const Cell cell{draw(), draw()};
    map.set_state(cell, states[cell] = static_cast<CellState>(random.below(3)));
    map.set_cost(cell, costs[cell] = static_cast<std::uint32_t>(random.next()));
  }
  for (int i = 0; i < 20000; ++i) {
    const Cell cell{draw(), draw()};
    ASSERT_EQ(map.state(cell), states.contains(cell) ? states[cell] : CellState::unknown);
    ASSERT_EQ(map.cost(cell), costs.contains(cell) ? costs[cell] : 0u);
  }
}

TEST(CostMap, TilesMeetAtZeroWithoutGapOrOverlap) {
  for (std::int32_t x = -400; x <= 400; ++x) {
    const Cell tile = CostMap::tile_of({x, -x});
    EXPECT_LE(tile.x * CostTile::kSide, x);
    EXPECT_GT((tile.x + 1) * CostTile::kSide, x);
    EXPECT_LT(CostMap::index_in_tile({x, -x}), CostTile::kCells);
  }
  constexpr std::int32_t kFar = std::numeric_limits<std::int32_t>::min() + 1;
  EXPECT_EQ(CostMap::tile_of({kFar, -kFar}), (Cell{-16777216, 16777215}));
}

TEST(Bounds, HoldEveryKnownCellAndNoMore) {
  EXPECT_FALSE(bounds(CostMap{}));
  Random random(2);
  for (int round = 0; round < 200; ++round) {
    CostMap map;
    map.set_state({5000, 5000}, CellState::unknown);
    map.set_cost({-5000, 77}, 12);
    CellRectangle expected{{1 << 30, 1 << 30}, {-(1 << 30), -(1 << 30)}};
    for (auto cells = 1 + random.below(6); cells > 0; --cells) {
      const Cell cell{static_cast<std::int32_t>(random.below(900)) - 450,
                      static_cast<std::int32_t>(random.below(900)) - 450};
      map.set_state(cell, cells % 2 == 0 ? CellState::free : CellState::occupied);
      expected.low = {std::min(expected.low.x, cell.x), std::min(expected.low.y, cell.y)};
      expected.high = {std::max(expected.high.x, cell.x + 1), std::max(expected.high.y, cell.y + 1)};
    }
    ASSERT_EQ(bounds(map), expected);
  }
}

}  // namespace
}  // namespace scanway
