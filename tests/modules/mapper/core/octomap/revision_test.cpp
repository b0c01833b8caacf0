#include <gtest/gtest.h>

#include <stdexcept>

#include "common/random/random.h"
#include "modules/mapper/core/octomap/occupancy_tree.h"

namespace scanway {
namespace {

MapPoints view_of_a_room(Random& random, double side) {
  MapPoints sweep;
  sweep.origin = Eigen::Vector3d(random.normal(), random.normal(), random.normal()) * 0.2;
  for (int i = 0; i < 400; ++i) {
    Eigen::Vector3d p(random.uniform(), random.uniform(), random.uniform());
    const std::uint64_t wall = random.below(7);
    if (wall < 6) p[static_cast<Eigen::Index>(wall / 2)] = static_cast<double>(wall % 2);
    sweep.points.push_back(((p - Eigen::Vector3d::Constant(0.5)) * 2.0 * side).cast<float>());
  }
  return sweep;
}

OccupancyTreeConfig config_of(std::uint64_t scene) {
  OccupancyTreeConfig config{scene % 2 == 0 ? 0.1 : 0.05, scene % 3 == 0 ? 2.0 : -1.0, scene % 4 == 0};
  config.revisable = true;
  return config;
}

std::string tree_of(const std::vector<MapPoints>& sweeps, const OccupancyTreeConfig& config, std::size_t without) {
  OccupancyTree tree(config);
  for (std::size_t i = 0; i < sweeps.size(); ++i) {
    if (i != without) tree.insert(sweeps[i]);
  }
  return tree.ot_bytes();
}

TEST(RevisableTree, AnySweepOfTenCanBeWithdrawnAndPutBack) {
  for (std::uint64_t scene = 0; scene < 6; ++scene) {
    Random random(scene + 1);
    std::vector<MapPoints> sweeps;
    for (int i = 0; i < 10; ++i) sweeps.push_back(view_of_a_room(random, 1.0 + 2.0 * random.uniform()));
    const OccupancyTreeConfig config = config_of(scene);
    OccupancyTree tree(config);
    for (const MapPoints& sweep : sweeps) tree.insert(sweep);
    const std::string all = tree.ot_bytes();
    for (std::size_t without = 0; without < sweeps.size(); ++without) {
      tree.withdraw(without);
      tree.settle();
      ASSERT_TRUE(tree.ot_bytes() == tree_of(sweeps, config, without)) << scene << ", sweep " << without;
      tree.replace(without, sweeps[without]);
      tree.settle();
      ASSERT_TRUE(tree.ot_bytes() == all) << scene << ", sweep " << without;
    }
  }
}

TEST(RevisableTree, ASweepThatMovedLeavesNothingWhereItWas) {
  Random random(21);
  std::vector<MapPoints> wrong, right;
  for (int i = 0; i < 6; ++i) {
    right.push_back(view_of_a_room(random, 2.0));
    wrong.push_back(view_of_a_room(random, 3.0));
  }
  OccupancyTree tree(config_of(1));
  for (const MapPoints& sweep : wrong) tree.insert(sweep);
  for (const std::size_t i : {4u, 0u, 5u, 1u, 3u, 2u}) tree.replace(i, right[i]);
  tree.settle();
  EXPECT_TRUE(tree.ot_bytes() == tree_of(right, config_of(1), right.size()));
}

TEST(RevisableTree, WithoutSweepsItIsEmpty) {
  Random random(22);
  OccupancyTree tree(config_of(2));
  for (int i = 0; i < 3; ++i) tree.insert(view_of_a_room(random, 2.0));
  for (const std::size_t i : {1u, 0u, 2u}) tree.withdraw(i);
  tree.settle();
  EXPECT_TRUE(tree.ot_bytes() == OccupancyTree(config_of(2)).ot_bytes());
  EXPECT_EQ(tree.size().nodes, 0u);
  tree.insert(view_of_a_room(random, 2.0));
  EXPECT_GT(tree.size().nodes, 0u);
  EXPECT_THROW(tree.withdraw(4), std::logic_error);
  EXPECT_THROW(OccupancyTree({}).withdraw(0), std::logic_error);
}

}  // namespace
}  // namespace scanway
