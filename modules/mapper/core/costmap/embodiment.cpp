#include "modules/mapper/core/costmap/embodiment.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <set>
#include <utility>
#include <vector>

#include "common/math/repeatable.h"
#include "common/parallel/blocks.h"
#include "modules/mapper/core/costmap/distance_field.h"
#include "modules/mapper/core/costmap/occupancy_window.h"

namespace scanway {
namespace {

constexpr std::int32_t kSide = CostTile::kSide;
constexpr int kPaperReach = 5;  // cells along an axis: exp(-6^2 / 2) rounds to nothing
constexpr int kMaxReach = 250;  // cells: what a distance field of bytes can hold

using Costs = std::array<std::uint32_t, CostTile::kCells>;

/// exp(-(dx^2 + dy^2) / 2) in 2^-24ths, rows and columns from -kPaperReach.
struct PaperKernel {
  static constexpr int kRows = 2 * kPaperReach + 1;
  static constexpr int kStride = 12;  // a row and a zero: three vectors of four
  std::array<std::uint32_t, kRows * kStride> rows{};

  PaperKernel() {
    for (int dy = -kPaperReach; dy <= kPaperReach; ++dy) {
      for (int dx = -kPaperReach; dx <= kPaperReach; ++dx) {
        const double value = repeatable::exp(-0.5 * (dx * dx + dy * dy)) * kCostOne;
        rows[static_cast<std::size_t>((dy + kPaperReach) * kStride + dx + kPaperReach)] =
            static_cast<std::uint32_t>(std::floor(value + 0.5));
      }
    }
  }
};

/// The paper's cost of a tile, from a window with kPaperReach cells around it.
void paper_costs(const OccupancyWindow& window, const PaperKernel& kernel, Costs& costs) {
  // Scattered into a padded square, so that no kernel row needs its ends cut.
  constexpr int padded = kSide + 4 * kPaperReach + 1;
  std::vector<std::uint32_t> sums(static_cast<std::size_t>(padded) * padded, 0);
  for (int y = 0; y < window.height; ++y) {
    for (int x = 0; x < window.width; ++x) {
      if (window.occupied[static_cast<std::size_t>(y) * window.width + x] == 0) continue;
      for (int r = 0; r < PaperKernel::kRows; ++r) {
        std::uint32_t* sum = &sums[static_cast<std::size_t>(y + r) * padded + x];
        const std::uint32_t* row = &kernel.rows[static_cast<std::size_t>(r) * PaperKernel::kStride];
        for (int i = 0; i < PaperKernel::kStride; ++i) sum[i] += row[i];
      }
    }
  }
  for (int y = 0; y < kSide; ++y) {
    const std::uint32_t* from = &sums[static_cast<std::size_t>(y + 2 * kPaperReach) * padded + 2 * kPaperReach];
    std::copy(from, from + kSide, &costs[static_cast<std::size_t>(y) * kSide]);
  }
}

/// Cost by squared distance in cells.
std::vector<std::uint32_t> footprint_table(const Robot& robot, double resolution, int reach) {
  const double inscribed = robot.inscribed_radius_m(), circumscribed = robot.circumscribed_radius_m();
  std::vector<std::uint32_t> table(static_cast<std::size_t>(reach + 1) * (reach + 1) + 1, 0);
  for (std::size_t squared = 0; squared < table.size(); ++squared) {
    const double clearance = (std::sqrt(static_cast<double>(squared)) - std::sqrt(0.5)) * resolution;
    const double t = (clearance - circumscribed) / (2.0 * circumscribed);
    if (clearance < inscribed) {
      table[squared] = kCostLethal;
    } else if (t <= 0.0) {
      table[squared] = kCostOne;
    } else if (t < 1.0) {
      table[squared] = static_cast<std::uint32_t>(std::floor((1.0 - t) * (1.0 - t) * kCostOne + 0.5));
    }
  }
  return table;
}

/// A square of tiles that is computed at once; large squares spend less on what is around them.
constexpr std::int32_t kBlock = 4;  // tiles along an edge

std::int32_t block_of(std::int32_t tile) { return (tile >= 0 ? tile : tile - kBlock + 1) / kBlock; }

/// Squares of tiles within reach of a tile that holds anything.
std::vector<Cell> blocks_in_reach(const CostMap& map, int reach) {
  const std::int32_t around = (reach + kSide - 1) / kSide;
  std::set<Cell> blocks;
  for (const auto& [tile, content] : map.tiles) {
    for (std::int32_t y = block_of(tile.y - around); y <= block_of(tile.y + around); ++y) {
      for (std::int32_t x = block_of(tile.x - around); x <= block_of(tile.x + around); ++x) blocks.insert({x, y});
    }
  }
  return {blocks.begin(), blocks.end()};
}

using TileCosts = std::vector<std::pair<Cell, std::unique_ptr<Costs>>>;

TileCosts paper_block(const CostMap& map, Cell block, const PaperKernel& kernel) {
  TileCosts result;
  for (std::int32_t i = 0; i < kBlock * kBlock; ++i) {
    const Cell tile{block.x * kBlock + i % kBlock, block.y * kBlock + i / kBlock};
    const Cell corner{tile.x * kSide - kPaperReach, tile.y * kSide - kPaperReach};
    const int width = kSide + 2 * kPaperReach;
    const OccupancyWindow window = OccupancyWindow::of(map, corner, width, width);
    if (!window.any) continue;
    result.emplace_back(tile, std::make_unique<Costs>());
    paper_costs(window, kernel, *result.back().second);
  }
  return result;
}

TileCosts footprint_block(const CostMap& map, Cell block, const std::vector<std::uint32_t>& table, int reach) {
  TileCosts result;
  const Cell corner{block.x * kBlock * kSide - reach, block.y * kBlock * kSide - reach};
  const int width = kBlock * kSide + 2 * reach;
  const OccupancyWindow window = OccupancyWindow::of(map, corner, width, width);
  if (!window.any) return result;
  const std::vector<std::uint32_t> squared = squared_distances(window, reach);
  for (std::int32_t i = 0; i < kBlock * kBlock; ++i) {
    const std::int32_t column = i % kBlock, row = i / kBlock;
    auto costs = std::make_unique<Costs>();
    for (int y = 0; y < kSide; ++y) {
      const std::uint32_t* from = &squared[static_cast<std::size_t>(reach + row * kSide + y) * width + reach +
                                           static_cast<std::size_t>(column) * kSide];
      for (int x = 0; x < kSide; ++x) (*costs)[static_cast<std::size_t>(y) * kSide + x] = table[from[x]];
    }
    result.emplace_back(Cell{block.x * kBlock + column, block.y * kBlock + row}, std::move(costs));
  }
  return result;
}

void write_costs(CostMap& map, std::vector<TileCosts>& blocks) {
  for (auto& [index, tile] : map.tiles) tile.cost.fill(0);
  const auto is_zero = [](std::uint32_t cost) { return cost == 0; };
  for (TileCosts& block : blocks) {
    for (auto& [index, costs] : block) {
      const auto known = map.tiles.find(index);
      if (known != map.tiles.end()) {
        known->second.cost = *costs;
      } else if (!std::all_of(costs->begin(), costs->end(), is_zero)) {
        map.tiles[index].cost = *costs;
      }
    }
  }
  std::erase_if(map.tiles, [&](const auto& entry) {
    const auto is_unknown = [](CellState state) { return state == CellState::unknown; };
    const CostTile& tile = entry.second;
    return std::all_of(tile.state.begin(), tile.state.end(), is_unknown) &&
           std::all_of(tile.cost.begin(), tile.cost.end(), is_zero);
  });
}

}  // namespace

void embody(CostMap& map, const Robot& robot, Embodiment embodiment) {
  const bool paper = embodiment == Embodiment::paper;
  const double dear = 3.0 * robot.circumscribed_radius_m() / map.resolution_m + 1.0;
  const int reach = paper ? kPaperReach : std::clamp(static_cast<int>(std::ceil(dear)), 1, kMaxReach);
  const std::vector<Cell> blocks = blocks_in_reach(map, reach);
  std::vector<TileCosts> costs(blocks.size());
  const PaperKernel kernel;
  const std::vector<std::uint32_t> table = footprint_table(robot, map.resolution_m, reach);
  for_blocks(blocks.size(), 1, [&](std::size_t begin, std::size_t, std::size_t) {
    costs[begin] = paper ? paper_block(map, blocks[begin], kernel) : footprint_block(map, blocks[begin], table, reach);
  });
  write_costs(map, costs);
}

}  // namespace scanway
