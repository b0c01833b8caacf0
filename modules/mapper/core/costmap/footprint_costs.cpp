#include <algorithm>
#include <cmath>

#include "modules/mapper/core/costmap/distance_field.h"
#include "modules/mapper/core/costmap/occupancy_window.h"
#include "modules/mapper/core/costmap/tile_costs.h"

namespace scanway {
namespace {

constexpr std::int32_t kSide = CostTile::kSide;
constexpr int kMaxReach = 250;  // cells: what a distance field of bytes can hold

int reach_in_cells(const Robot& robot, double resolution) {
  const double dear = 3.0 * robot.circumscribed_radius_m() / resolution + 1.0;
  return std::clamp(static_cast<int>(std::ceil(dear)), 1, kMaxReach);
}

}  // namespace

FootprintCosts::FootprintCosts(const Robot& robot, double resolution)
    : reach_(reach_in_cells(robot, resolution)),
      by_squared_distance_(static_cast<std::size_t>(reach_ + 1) * (reach_ + 1) + 1, 0) {
  const double inscribed = robot.inscribed_radius_m(), circumscribed = robot.circumscribed_radius_m();
  for (std::size_t squared = 0; squared < by_squared_distance_.size(); ++squared) {
    const double clearance = (std::sqrt(static_cast<double>(squared)) - std::sqrt(0.5)) * resolution;
    const double t = (clearance - circumscribed) / (2.0 * circumscribed);
    std::uint32_t& cost = by_squared_distance_[squared];
    if (clearance < inscribed) {
      cost = kCostLethal;
    } else if (t <= 0.0) {
      cost = kCostOne;
    } else if (t < 1.0) {
      cost = static_cast<std::uint32_t>(std::floor((1.0 - t) * (1.0 - t) * kCostOne + 0.5));
    }
  }
}

std::vector<FootprintCosts::Tile> FootprintCosts::of_tiles(const CostMap& map, Cell first, Cell last) const {
  std::vector<Tile> tiles;
  const Cell corner{first.x * kSide - reach_, first.y * kSide - reach_};
  const int width = (last.x - first.x + 1) * kSide + 2 * reach_, height = (last.y - first.y + 1) * kSide + 2 * reach_;
  const OccupancyWindow window = OccupancyWindow::of(map, corner, width, height);
  if (!window.any) return tiles;
  const std::vector<std::uint32_t> squared = squared_distances(window, reach_);
  for (std::int32_t ty = first.y; ty <= last.y; ++ty) {
    for (std::int32_t tx = first.x; tx <= last.x; ++tx) {
      Tile& tile = tiles.emplace_back();
      tile.index = {tx, ty};
      for (int y = 0; y < kSide; ++y) {
        const std::uint32_t* from = &squared[static_cast<std::size_t>(ty * kSide + y - corner.y) * width +
                                             static_cast<std::size_t>(tx * kSide - corner.x)];
        for (int x = 0; x < kSide; ++x) {
          tile.costs[static_cast<std::size_t>(y * kSide + x)] = by_squared_distance_[from[x]];
        }
      }
    }
  }
  return tiles;
}

}  // namespace scanway
