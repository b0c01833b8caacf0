#include "modules/mapper/core/octomap/occupancy_tree.h"

#include <sstream>

#include "modules/mapper/core/octomap/sweep_voxels.h"
#include "modules/mapper/core/octomap/tree_update.h"

namespace scanway {

OccupancyTree::OccupancyTree(const OccupancyTreeConfig& config)
    : config_(config), tree_(std::make_unique<SweptOcTree>(config.resolution_m)) {}

OccupancyTree::~OccupancyTree() = default;
OccupancyTree::OccupancyTree(OccupancyTree&&) noexcept = default;
OccupancyTree& OccupancyTree::operator=(OccupancyTree&&) noexcept = default;

void OccupancyTree::insert(const MapPoints& points) {
  const Eigen::Vector3f origin = points.origin.cast<float>();
  const KeyGrid grid(config_.resolution_m);
  VoxelBricks bricks = sweep_voxels(points.points, {origin.x(), origin.y(), origin.z()}, grid, config_);
  tree_->update(bricks);
}

const octomap::OcTree& OccupancyTree::tree() const { return *tree_; }

std::string OccupancyTree::ot_bytes() const {
  std::ostringstream bytes;
  tree_->write(bytes);
  return std::move(bytes).str();
}

std::string OccupancyTree::bt_bytes() const {
  // What writeBinary does, but on a copy, for it sets every node to its most likely state and prunes, and without the
  // lines that it prints.
  octomap::OcTree most_likely(*tree_);
  most_likely.toMaxLikelihood();
  most_likely.prune();
  std::ostringstream bytes;
  bytes
      << "# Octomap OcTree binary file\n# (feel free to add / change comments, but leave the first line as it is!)\n#\n"
      << "id " << most_likely.getTreeType() << "\nsize " << most_likely.size() << "\nres "
      << most_likely.getResolution() << "\ndata\n";
  most_likely.writeBinaryData(bytes);
  return std::move(bytes).str();
}

}  // namespace scanway
