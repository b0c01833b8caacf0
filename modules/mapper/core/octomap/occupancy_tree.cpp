#include "modules/mapper/core/octomap/occupancy_tree.h"

#include <algorithm>
#include <iterator>
#include <stdexcept>

#include "modules/mapper/core/octomap/log_odds_tree.h"
#include "modules/mapper/core/octomap/sweep_voxels.h"

namespace scanway {

OccupancyTree::OccupancyTree(const OccupancyTreeConfig& config)
    : config_(config), tree_(std::make_unique<LogOddsTree>()) {}

OccupancyTree::~OccupancyTree() = default;
OccupancyTree::OccupancyTree(OccupancyTree&&) noexcept = default;
OccupancyTree& OccupancyTree::operator=(OccupancyTree&&) noexcept = default;

void OccupancyTree::insert(const MapPoints& points) {
  VoxelBricks bricks = voxels_of(points);
  tree_->update(bricks);
  if (config_.revisable) history_.put(sweeps_, bricks);
  ++sweeps_;
}

void OccupancyTree::withdraw(SweepNumber sweep) { tree_->remake(forget(sweep), history_); }

void OccupancyTree::replace(SweepNumber sweep, const MapPoints& points) {
  const std::vector<VoxelBricks::BrickNumber> before = forget(sweep);
  VoxelBricks bricks = voxels_of(points);
  history_.put(sweep, bricks);
  const std::vector<VoxelBricks::BrickNumber> now = bricks.numbers();
  std::vector<VoxelBricks::BrickNumber> touched;
  std::set_union(before.begin(), before.end(), now.begin(), now.end(), std::back_inserter(touched));
  tree_->remake(touched, history_);
}

std::vector<VoxelBricks::BrickNumber> OccupancyTree::forget(SweepNumber sweep) {
  if (!config_.revisable) throw std::logic_error("OccupancyTree: its sweeps are not kept");
  if (sweep >= sweeps_) throw std::logic_error("OccupancyTree: no such sweep");
  return history_.forget(sweep);
}

VoxelBricks OccupancyTree::voxels_of(const MapPoints& points) const {
  const Eigen::Vector3f origin = points.origin.cast<float>();
  const KeyGrid grid(config_.resolution_m);
  return sweep_voxels(points.points, {origin.x(), origin.y(), origin.z()}, grid, config_);
}

OccupancyTree::Size OccupancyTree::size() const {
  const LogOddsTree::Size size = tree_->size();
  return {size.nodes, size.leaves};
}

std::string OccupancyTree::ot_bytes() const { return tree_->ot_bytes(config_.resolution_m); }

std::string OccupancyTree::bt_bytes() const { return tree_->bt_bytes(config_.resolution_m); }

}  // namespace scanway
