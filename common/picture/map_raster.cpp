#include "common/picture/map_raster.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace scanway {
namespace {

Colour colour_of(CellState state, std::uint32_t cost) {
  if (state == CellState::occupied) return kOccupiedColour;
  if (cost == kCostLethal) return kLethalColour;
  const Colour ground = state == CellState::free ? kFreeColour : kUnknownColour;
  return cost == 0 ? ground : mix(ground, kDearestColour, std::sqrt(static_cast<double>(cost) / kCostOne));
}

/// What the cells of one spot of the picture are mixed to.
struct Blend {
  std::array<std::uint32_t, 3> sum{};
  std::uint32_t cells = 0;
  std::uint32_t occupied = 0;

  void add(Colour colour, std::uint32_t times = 1) {
    sum[0] += times * colour.red;
    sum[1] += times * colour.green;
    sum[2] += times * colour.blue;
    cells += times;
  }

  /// `all`: the cells that the spot covers; those that were not added are unknown.
  Colour colour(std::uint32_t all) {
    if (cells < all) add(kUnknownColour, all - cells);
    const auto mean = [&](std::uint32_t s) { return static_cast<std::uint8_t>(s / cells); };
    const Colour blended{mean(sum[0]), mean(sum[1]), mean(sum[2])};
    // One occupied cell must not fade away among many free ones.
    return occupied == 0 ? blended : mix(blended, kOccupiedColour, 0.5 + 0.5 * occupied / cells);
  }
};

/// Spots of `side` x `side` cells over `part`, row by row from the top.
struct Spots {
  CellRectangle part;
  std::int32_t side;
  std::int32_t columns = static_cast<std::int32_t>((part.width() + side - 1) / side);
  std::int32_t rows = static_cast<std::int32_t>((part.height() + side - 1) / side);
  std::vector<Blend> blends = std::vector<Blend>(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));

  Blend& at(Cell cell) {
    const std::int32_t column = (cell.x - part.low.x) / side, row = rows - 1 - (cell.y - part.low.y) / side;
    return blends[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column)];
  }

  void add(Cell tile, const CostTile& cells) {
    const Cell low{tile.x * CostTile::kSide, tile.y * CostTile::kSide};
    const Cell from{std::max(low.x, part.low.x), std::max(low.y, part.low.y)};
    const Cell to{std::min(low.x + CostTile::kSide, part.high.x), std::min(low.y + CostTile::kSide, part.high.y)};
    for (std::int32_t y = from.y; y < to.y; ++y) {
      for (std::int32_t x = from.x; x < to.x; ++x) {
        const auto i = static_cast<std::size_t>((y - low.y) * CostTile::kSide + (x - low.x));
        Blend& blend = at({x, y});
        blend.add(colour_of(cells.state[i], cells.cost[i]));
        blend.occupied += cells.state[i] == CellState::occupied;
      }
    }
  }
};

}  // namespace

Raster raster_of(const CostMap& map, const CellRectangle& part) {
  const auto long_side = std::max<std::int64_t>({part.width(), part.height(), 1});
  Spots spots{part, static_cast<std::int32_t>((long_side + kLongSide - 1) / kLongSide)};
  for (const auto& [tile, cells] : map.tiles) spots.add(tile, cells);
  const Eigen::Vector2d low = map.resolution_m * Eigen::Vector2d(part.low.x, part.low.y);
  Raster raster(spots.columns, spots.rows, map.resolution_m * spots.side,
                Eigen::Vector2d(map.origin_x_m, map.origin_y_m) + low, kUnknownColour);
  const auto cells_a_spot = static_cast<std::uint32_t>(spots.side) * static_cast<std::uint32_t>(spots.side);
  std::ranges::transform(spots.blends, raster.pixels.begin(), [&](Blend& b) { return b.colour(cells_a_spot); });
  return enlarged(raster, static_cast<int>(std::clamp<std::int64_t>(kLongSide / long_side, 1, 16)));
}

}  // namespace scanway
