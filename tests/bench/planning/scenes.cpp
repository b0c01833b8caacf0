#include "tests/bench/planning/scenes.h"

#include <algorithm>
#include <cmath>

#include "common/random/random.h"
#include "common/robot/robot.h"

namespace scanway::bench {
namespace {

/// Calls visit(cell, state, cost) row by row.
template <class Map, class Visit>
void for_cells(Map& map, std::int32_t side, Visit&& visit) {
  for (Cell cell{0, 0}; cell.y < side; ++cell.y) {
    for (cell.x = 0; cell.x < side;) {
      auto& tile = map.tiles.at(CostMap::tile_of(cell));
      const std::int32_t end = std::min(side, (cell.x / CostTile::kSide + 1) * CostTile::kSide);
      for (; cell.x < end; ++cell.x) {
        const std::size_t at = CostMap::index_in_tile(cell);
        visit(cell, tile.state[at], tile.cost[at]);
      }
    }
  }
}

Scene free_scene(const char* name, planning::BodyMode mode, std::int32_t side) {
  Scene scene{name, mode, {}, side};
  scene.map.resolution_m = 1.0;
  for (std::int32_t y = 0; y < side; y += CostTile::kSide) {
    for (std::int32_t x = 0; x < side; x += CostTile::kSide) scene.map.set_state({x, y}, CellState::free);
  }
  for_cells(scene.map, side, [](Cell, CellState& state, std::uint32_t&) { state = CellState::free; });
  return scene;
}

std::vector<Cell> tiles_of(Cell low, Cell high) {
  std::vector<Cell> tiles;
  const Cell first = CostMap::tile_of(low), last = CostMap::tile_of({high.x - 1, high.y - 1});
  for (Cell tile = first; tile.y <= last.y; ++tile.y) {
    for (tile.x = first.x; tile.x <= last.x; ++tile.x) tiles.push_back(tile);
  }
  return tiles;
}

}  // namespace

Scene rubble(std::int32_t side) {
  Scene scene = free_scene("rubble", planning::BodyMode::point, side);
  Random random(1);
  for_cells(scene.map, side, [&](Cell cell, CellState& state, std::uint32_t&) {
    const bool corner = std::max(cell.x, cell.y) < 5 || std::min(cell.x, cell.y) > side - 6;
    if (random.below(5) == 0 && !corner) state = CellState::occupied;
  });
  return scene;
}

Scene rooms(std::int32_t side) {
  constexpr std::int32_t kRoom = 80;
  Scene scene = free_scene("rooms", planning::BodyMode::point, side);
  Random random(2);
  const auto wall = [&](std::int32_t line, std::int32_t from, bool upright) {
    const bool door = random.below(4) != 0;
    const auto at = static_cast<std::int32_t>(2 + random.below(kRoom - 8));
    for (std::int32_t i = 0; i < kRoom; ++i) {
      if (door && i >= at && i < at + 4) continue;
      scene.map.set_state(upright ? Cell{line, from + i} : Cell{from + i, line}, CellState::occupied);
    }
  };
  for (std::int32_t line = kRoom - 1; line < side - 1; line += kRoom) {
    for (std::int32_t from = 0; from < side; from += kRoom) {
      wall(line, from, true);
      wall(line, from, false);
    }
  }
  return scene;
}

Scene weighted(std::int32_t side) {
  Scene scene = free_scene("weighted", planning::BodyMode::paper, side);
  for_cells(scene.map, side, [](Cell cell, CellState&, std::uint32_t& cost) {
    const double x = cell.x, y = cell.y;
    const double hills = 0.5 + 0.25 * (std::sin(x / 37.0) * std::cos(y / 53.0) + std::sin((x + 2.0 * y) / 91.0));
    cost = static_cast<std::uint32_t>(hills * kCostOne);
  });
  return scene;
}

std::vector<Cell> scatter(Scene& scene, Cell low, Cell high) {
  Random random(3);
  for (std::int32_t y = low.y; y < high.y; ++y) {
    for (std::int32_t x = low.x; x < high.x; ++x) {
      if (random.below(20) == 0) scene.map.set_state({x, y}, CellState::occupied);
    }
  }
  return tiles_of(low, high);
}

std::vector<Cell> fill(Scene& scene, Cell low, Cell high, CellState state) {
  low = {std::max(low.x, 0), std::max(low.y, 0)};
  high = {std::min(high.x, scene.side), std::min(high.y, scene.side)};
  for (std::int32_t y = low.y; y < high.y; ++y) {
    for (std::int32_t x = low.x; x < high.x; ++x) scene.map.set_state({x, y}, state);
  }
  return tiles_of(low, high);
}

PlainMap plain(const Scene& scene) {
  PlainMap map{scene.side, {}};
  const double weight = std::floor(64.0 * Robot().planning.clearance_weight + 0.5);
  for_cells(scene.map, scene.side, [&](Cell, CellState state, std::uint32_t cost) {
    const double share = scene.mode == planning::BodyMode::point ? 0.0 : std::ldexp(cost, -24);
    const double price = (64.0 + std::floor(weight * share)) / 64.0;
    map.price.push_back(state == CellState::free ? static_cast<float>(price) : 0.0f);
  });
  return map;
}

}  // namespace scanway::bench
