#include "tests/modules/mapper/core/octomap/support/reference.h"

#include <octomap/OcTree.h>

#include <sstream>

namespace scanway {

TreeFiles files_of_liboctomap(const std::vector<MapPoints>& sweeps, const OccupancyTreeConfig& config) {
  octomap::OcTree tree(config.resolution_m);
  for (const MapPoints& sweep : sweeps) {
    octomap::Pointcloud cloud;
    for (const Eigen::Vector3f& p : sweep.points) cloud.push_back(p.x(), p.y(), p.z());
    const octomap::point3d origin(float(sweep.origin.x()), float(sweep.origin.y()), float(sweep.origin.z()));
    const double max_range = config.max_range_m > 0.0 ? config.max_range_m : -1.0;
    tree.insertPointCloud(cloud, origin, max_range, false, config.discretize);
  }
  std::ostringstream ot, bt;
  tree.write(ot);
  tree.writeBinary(bt);
  return {ot.str(), bt.str()};
}

TreeFiles files_of_ours(const std::vector<MapPoints>& sweeps, const OccupancyTreeConfig& config) {
  OccupancyTree tree(config);
  for (const MapPoints& sweep : sweeps) tree.insert(sweep);
  const std::string bt = tree.bt_bytes();  // must not change what .ot then says
  return {tree.ot_bytes(), bt};
}

}  // namespace scanway
