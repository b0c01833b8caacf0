#include "modules/mapper/core/costmap/paper_projection.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace scanway {
namespace {

bool within_reach(const Eigen::Vector3f& p, const std::vector<Eigen::Vector3d>& origins, double reach) {
  return std::any_of(origins.begin(), origins.end(), [&](const Eigen::Vector3d& origin) {
    const double dx = p.x() - origin.x(), dy = p.y() - origin.y();
    return dx * dx + dy * dy <= reach * reach;
  });
}

void fill_free(CostMap& map, Cell low, Cell high) {
  constexpr std::int32_t side = CostTile::kSide;
  const Cell first = CostMap::tile_of(low), last = CostMap::tile_of(high);
  for (std::int32_t ty = first.y; ty <= last.y; ++ty) {
    for (std::int32_t tx = first.x; tx <= last.x; ++tx) {
      CostTile& tile = map.tiles[{tx, ty}];
      const std::int32_t x0 = std::max(low.x - tx * side, 0), x1 = std::min(high.x - tx * side + 1, side);
      const std::int32_t y0 = std::max(low.y - ty * side, 0), y1 = std::min(high.y - ty * side + 1, side);
      for (std::int32_t y = y0; y < y1; ++y) {
        std::fill(&tile.state[static_cast<std::size_t>(y) * side + x0],
                  &tile.state[static_cast<std::size_t>(y) * side] + x1, CellState::free);
      }
    }
  }
}

}  // namespace

void project_as_paper(CostMap& map, const PointCloud& registered, const GroundPlane& ground, const Robot& robot,
                      const std::vector<Eigen::Vector3d>& origins, double reach_m) {
  constexpr std::int32_t kMax = std::numeric_limits<std::int32_t>::max();
  Cell low{kMax, kMax}, high{-kMax, -kMax};
  std::vector<Cell> obstacles;
  const double sigma = robot.laser.range_sigma_m;
  for (const Eigen::Vector3f& point : registered.points) {
    if (!within_reach(point, origins, reach_m)) continue;
    const Cell cell{static_cast<std::int32_t>(std::floor(point.x() / map.resolution_m)),
                    static_cast<std::int32_t>(std::floor(point.y() / map.resolution_m))};
    low = {std::min(low.x, cell.x), std::min(low.y, cell.y)};
    high = {std::max(high.x, cell.x), std::max(high.y, cell.y)};
    const double above = ground.distance(point.cast<double>());
    const bool is_ground = above >= -sigma && above <= robot.body.climbable_step_m + sigma;
    if (!is_ground && above <= robot.body.height_m) obstacles.push_back(cell);
  }
  map.tiles.clear();
  if (low.x > high.x) return;
  fill_free(map, low, high);
  for (const Cell& cell : obstacles) map.set_state(cell, CellState::occupied);
}

}  // namespace scanway
