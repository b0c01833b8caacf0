#include "modules/mapper/core/octomap/occupancy_tree.h"

#include "modules/mapper/core/octomap/log_odds_tree.h"
#include "modules/mapper/core/octomap/sweep_voxels.h"

namespace scanway {

OccupancyTree::OccupancyTree(const OccupancyTreeConfig& config)
    : config_(config), tree_(std::make_unique<LogOddsTree>()) {}

OccupancyTree::~OccupancyTree() = default;
OccupancyTree::OccupancyTree(OccupancyTree&&) noexcept = default;
OccupancyTree& OccupancyTree::operator=(OccupancyTree&&) noexcept = default;

void OccupancyTree::insert(const MapPoints& points) {
  const Eigen::Vector3f origin = points.origin.cast<float>();
  const KeyGrid grid(config_.resolution_m);
  VoxelBricks bricks = sweep_voxels(points.points, {origin.x(), origin.y(), origin.z()}, grid, config_);
  tree_->update(bricks);
}

OccupancyTree::Size OccupancyTree::size() const {
  const LogOddsTree::Size size = tree_->size();
  return {size.nodes, size.leaves};
}

std::string OccupancyTree::ot_bytes() const { return tree_->ot_bytes(config_.resolution_m); }

std::string OccupancyTree::bt_bytes() const { return tree_->bt_bytes(config_.resolution_m); }

}  // namespace scanway
