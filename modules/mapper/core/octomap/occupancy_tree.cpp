#include "modules/mapper/core/octomap/occupancy_tree.h"

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "modules/mapper/core/octomap/log_odds_tree.h"
#include "modules/mapper/core/octomap/sweep_voxels.h"

namespace scanway {

OccupancyTree::OccupancyTree(const OccupancyTreeConfig& config, std::shared_ptr<ByteStore> store)
    : config_(config), tree_(std::make_unique<LogOddsTree>()), history_(std::move(store)) {}

OccupancyTree::~OccupancyTree() = default;
OccupancyTree::OccupancyTree(OccupancyTree&&) noexcept = default;
OccupancyTree& OccupancyTree::operator=(OccupancyTree&&) noexcept = default;

void OccupancyTree::insert(const MapPoints& points) {
  VoxelBricks bricks = voxels_of(points);
  tree_->update(bricks);
  if (config_.revisable) history_.put(sweeps_, bricks);
  ++sweeps_;
}

void OccupancyTree::withdraw(SweepNumber sweep) {
  if (!config_.revisable) throw std::logic_error("OccupancyTree: its sweeps are not kept");
  if (sweep >= sweeps_) throw std::logic_error("OccupancyTree: no such sweep");
  touch(history_.forget(sweep));
}

void OccupancyTree::replace(SweepNumber sweep, const MapPoints& points) {
  withdraw(sweep);
  VoxelBricks bricks = voxels_of(points);
  history_.put(sweep, bricks);
  touch(bricks.numbers());
}

void OccupancyTree::touch(const BrickNumbers& numbers) {
  BrickNumbers both;
  std::set_union(unsettled_.begin(), unsettled_.end(), numbers.begin(), numbers.end(), std::back_inserter(both));
  unsettled_ = std::move(both);
}

void OccupancyTree::settle() { tree_->remake(std::exchange(unsettled_, {}), history_); }

VoxelBricks OccupancyTree::voxels_of(const MapPoints& points) const {
  const Eigen::Vector3f origin = points.origin.cast<float>();
  const KeyGrid grid(config_.resolution_m);
  return sweep_voxels(points.points, {origin.x(), origin.y(), origin.z()}, grid, config_);
}

OccupancyTree::Size OccupancyTree::size() const {
  const LogOddsTree::Size size = tree_->size();
  return {size.nodes, size.leaves};
}

std::string OccupancyTree::ot_bytes() const {
  std::string bytes;
  write_ot([&bytes](std::string_view part) { bytes += part; });
  return bytes;
}

void OccupancyTree::write_ot(const std::function<void(std::string_view)>& take) const {
  tree_->write_ot(config_.resolution_m, take);
}

std::string OccupancyTree::bt_bytes() const { return tree_->bt_bytes(config_.resolution_m); }

}  // namespace scanway
