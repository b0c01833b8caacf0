#include "modules/tools/compare/cells/map_comparison.h"

#include <cmath>

#include "common/parallel/blocks.h"

namespace scanway::tools {
namespace {

using simulator::CellTruth;
using simulator::CellWindow;

constexpr std::size_t kRowsAtOnce = 16;

class MapInWorld {
 public:
  MapInWorld(const CostMap& map, const Pose& X_map_world) : map_(map), X_(X_map_world) {}

  Cell cell(double x, double y) const {
    const Eigen::Vector3d p = X_ * Eigen::Vector3d(x, y, 0.0);
    const auto index = [&](double at, double origin) {
      return static_cast<std::int32_t>(std::floor((at - origin) / map_.resolution_m));
    };
    return {index(p.x(), map_.origin_x_m), index(p.y(), map_.origin_y_m)};
  }
  CellState state(Cell cell) const { return map_.state(cell); }
  bool marked_near(Cell cell) const {
    const int reach = static_cast<int>(std::floor(kMarkReach_m / map_.resolution_m + 1e-6));
    for (int dy = -reach; dy <= reach; ++dy) {
      for (int dx = -reach; dx <= reach; ++dx) {
        if (dx * dx + dy * dy > reach * reach) continue;
        if (state({cell.x + dx, cell.y + dy}) == CellState::occupied) return true;
      }
    }
    return false;
  }

 private:
  const CostMap& map_;
  Pose X_;
};

void count_free(CellState state, CellCounts& counts) {
  ++counts.free;
  if (state == CellState::occupied) ++counts.free_called_occupied;
  if (state == CellState::unknown) ++counts.free_called_unknown;
}

void count_occupied(const MapInWorld& map, Cell cell, CellCounts& counts) {
  ++counts.occupied;
  if (map.state(cell) != CellState::free) return;
  ++counts.occupied_called_free;
  if (!map.marked_near(cell)) ++counts.occupied_unmarked;
}

void count_drop_off(const MapInWorld& map, Cell cell, CellCounts& counts) {
  ++counts.drop_offs;
  if (map.marked_near(cell)) return;
  ++counts.drop_offs_unmarked;
  if (map.state(cell) == CellState::free) ++counts.drop_offs_open;
}

/// Ground is looked at where its centre is in sight; a thing, where there is ground beside it.
int sweeps_that_saw(CellTruth truth, std::uint8_t near, std::uint8_t visible) {
  return truth == CellTruth::occupied ? near : visible;
}

void count_cell(const MapInWorld& map, Cell cell, CellTruth truth, CellCounts& counts) {
  if (truth == CellTruth::free) count_free(map.state(cell), counts);
  if (truth == CellTruth::occupied) count_occupied(map, cell, counts);
  if (truth == CellTruth::drop_off) count_drop_off(map, cell, counts);
}

}  // namespace

CellCounts& CellCounts::operator+=(const CellCounts& other) {
  free += other.free;
  free_called_occupied += other.free_called_occupied;
  free_called_unknown += other.free_called_unknown;
  occupied += other.occupied;
  occupied_called_free += other.occupied_called_free;
  occupied_unmarked += other.occupied_unmarked;
  drop_offs += other.drop_offs;
  drop_offs_unmarked += other.drop_offs_unmarked;
  drop_offs_open += other.drop_offs_open;
  return *this;
}

MapComparison& MapComparison::operator+=(const MapComparison& other) {
  one += other.one;
  two += other.two;
  unseen += other.unseen;
  unseen_called_free += other.unseen_called_free;
  return *this;
}

MapComparison compare(const CostMap& map, const Pose& X_map_world, const simulator::TruthGrid& truth,
                      const SeenGround& seen) {
  const MapInWorld in_world(map, X_map_world);
  const CellWindow& window = seen.window;
  const auto width = static_cast<std::size_t>(window.width());
  return sum_blocks(window.size(), kRowsAtOnce * width, MapComparison{}, [&](std::size_t begin, std::size_t end) {
    MapComparison part;
    for (std::size_t i = begin; i < end; ++i) {
      const Cell at{window.low_x + static_cast<std::int32_t>(i % width),
                    window.low_y + static_cast<std::int32_t>(i / width)};
      const CellTruth here = truth.at(at);
      if (here == CellTruth::unknown) continue;
      const Cell cell = in_world.cell(window.centre(at.x), window.centre(at.y));
      if (seen.near[i] == 0) {
        ++part.unseen;
        part.unseen_called_free += in_world.state(cell) == CellState::free ? 1 : 0;
        continue;
      }
      const int sweeps = sweeps_that_saw(here, seen.near[i], seen.visible[i]);
      if (sweeps > 0) count_cell(in_world, cell, here, sweeps == 1 ? part.one : part.two);
    }
    return part;
  });
}

std::vector<std::size_t> lost_cells(const CostMap& map, const Pose& X_map_world, const simulator::TruthGrid& truth,
                                    const SeenGround& seen) {
  const MapInWorld in_world(map, X_map_world);
  std::vector<std::size_t> lost;
  for (std::int32_t y = seen.window.low_y; y < seen.window.high_y; ++y) {
    for (std::int32_t x = seen.window.low_x; x < seen.window.high_x; ++x) {
      const std::size_t i = seen.window.index(x, y);
      if (truth.at(Cell{x, y}) != CellTruth::free || seen.near[i] == 0 || seen.visible[i] < 2) continue;
      const Cell cell = in_world.cell(seen.window.centre(x), seen.window.centre(y));
      if (in_world.state(cell) != CellState::free) lost.push_back(i);
    }
  }
  return lost;
}

}  // namespace scanway::tools
