#include "modules/mapper/core/octomap/occupancy_tree.h"

#include <sstream>

#include <gtest/gtest.h>
#include <octomap/OcTree.h>

#include "common/random/random.h"

namespace scanway {
namespace {

MapPoints random_sweep(std::uint64_t seed) {
  Random random(seed);
  MapPoints points;
  points.origin = Eigen::Vector3d(random.normal(), random.normal(), 1.0 + random.uniform() / 3.0);
  for (int i = 0; i < 3000; ++i) {
    const Eigen::Vector3d p(random.normal() * 6.0, random.normal() * 6.0, random.uniform() * 2.0);
    points.points.push_back(p.cast<float>());
  }
  return points;
}

class OccupancyTreeModes : public ::testing::TestWithParam<OccupancyTreeConfig> {};

TEST_P(OccupancyTreeModes, BytesAreThoseOfLiboctomapItself) {
  const OccupancyTreeConfig config = GetParam();
  OccupancyTree ours(config);
  octomap::OcTree theirs(config.resolution_m);
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const MapPoints sweep = random_sweep(seed);
    ours.insert(sweep);
    octomap::Pointcloud cloud;
    for (const Eigen::Vector3f& p : sweep.points) cloud.push_back(octomap::point3d(p.x(), p.y(), p.z()));
    const octomap::point3d origin(static_cast<float>(sweep.origin.x()), static_cast<float>(sweep.origin.y()),
                                  static_cast<float>(sweep.origin.z()));
    theirs.insertPointCloud(cloud, origin, config.max_range_m, false, config.discretize);
  }
  const std::string bt_before_ot = ours.bt_bytes();  // must not change what .ot then says
  std::ostringstream ot, bt;
  theirs.write(ot);
  EXPECT_EQ(ours.ot_bytes(), ot.str());
  theirs.writeBinary(bt);
  EXPECT_EQ(bt_before_ot, bt.str());
  EXPECT_GT(ot.str().size(), 10000u);
}

INSTANTIATE_TEST_SUITE_P(All, OccupancyTreeModes,
                         ::testing::Values(OccupancyTreeConfig{0.1, 20.0, true}, OccupancyTreeConfig{0.1, 20.0, false},
                                           OccupancyTreeConfig{0.2, -1.0, false},
                                           OccupancyTreeConfig{0.05, 5.0, true}));

}  // namespace
}  // namespace scanway
