#include "modules/mapper/core/octomap/occupancy_tree.h"

#include <sstream>

#include <octomap/OcTree.h>

namespace scanway {

OccupancyTree::OccupancyTree(const OccupancyTreeConfig& config)
    : config_(config), tree_(std::make_unique<octomap::OcTree>(config.resolution_m)) {}

OccupancyTree::~OccupancyTree() = default;
OccupancyTree::OccupancyTree(OccupancyTree&&) noexcept = default;
OccupancyTree& OccupancyTree::operator=(OccupancyTree&&) noexcept = default;

void OccupancyTree::insert(const MapPoints& points) {
  octomap::Pointcloud cloud;
  cloud.reserve(points.points.size());
  for (const Eigen::Vector3f& p : points.points) cloud.push_back(p.x(), p.y(), p.z());
  const Eigen::Vector3f origin = points.origin.cast<float>();
  const double max_range = config_.max_range_m > 0.0 ? config_.max_range_m : -1.0;
  tree_->insertPointCloud(cloud, {origin.x(), origin.y(), origin.z()}, max_range, false, config_.discretize);
}

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
