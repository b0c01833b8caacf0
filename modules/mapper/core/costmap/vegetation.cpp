#include "modules/mapper/core/costmap/vegetation.h"

namespace scanway {

void leave_out_grass(std::vector<ObstacleReturn>& obstacles, const SoftGround& soft) {
  std::erase_if(obstacles, [&](const ObstacleReturn& obstacle) {
    return obstacle.above <= GroundPatches::kGrass_m && soft.at(obstacle.x, obstacle.y) == Softness::soft;
  });
}

void occupy_soft_ground(SweepEvidence& evidence, const SoftGround& soft, const Robot& robot, const Pose& X_map_sweep) {
  const double resolution = robot.mapping.cost_map_resolution_m;
  const double radius = robot.circumscribed_radius_m();
  const Eigen::Vector2d stand = X_map_sweep.translation().head<2>();
  for (auto& [index, tile] : evidence) {
    for (std::size_t cell = 0; cell < CostTile::kCells; ++cell) {
      if (tile.state(cell) != CellState::free) continue;
      const Eigen::Vector2d at(
          (index.x * CostTile::kSide + static_cast<std::int32_t>(cell % CostTile::kSide) + 0.5) * resolution,
          (index.y * CostTile::kSide + static_cast<std::int32_t>(cell / CostTile::kSide) + 0.5) * resolution);
      if ((at - stand).squaredNorm() <= radius * radius || soft.at(at.x(), at.y()) != Softness::soft) continue;
      tile.returns[cell] = 1;
    }
  }
}

}  // namespace scanway
