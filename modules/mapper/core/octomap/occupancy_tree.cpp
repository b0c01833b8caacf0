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
  // writeBinary sets every node to its most likely state and prunes: on a copy, for the tree must keep its log-odds.
  octomap::OcTree most_likely(*tree_);
  std::ostringstream bytes;
  most_likely.writeBinary(bytes);
  return std::move(bytes).str();
}

}  // namespace scanway
