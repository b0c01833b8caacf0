// Against liboctomap, which wrote the files and reads ours.
#include "common/octree/octree_file.h"

#include <gtest/gtest.h>
#include <octomap/OcTree.h>

#include <memory>
#include <sstream>
#include <string>

#include "common/files/input_error.h"
#include "common/random/random.h"

namespace scanway::test {
namespace {

constexpr double kResolution = 0.05;

octomap::OcTree random_tree(std::uint64_t seed, int rays) {
  octomap::OcTree tree(kResolution);
  Random random(seed);
  const auto coordinate = [&](double extent) { return static_cast<float>(extent * (2.0 * random.uniform() - 1.0)); };
  const octomap::point3d origin(coordinate(1.0), coordinate(1.0), coordinate(1.0));
  octomap::Pointcloud cloud;
  for (int i = 0; i < rays; ++i) cloud.push_back(coordinate(9.0), coordinate(9.0), coordinate(3.0));
  tree.insertPointCloud(cloud, origin);
  return tree;
}

std::string bt_of(octomap::OcTree tree) {
  std::ostringstream stream;
  tree.writeBinary(stream);
  return stream.str();
}

std::string ot_of(const octomap::OcTree& tree) {
  std::ostringstream stream;
  tree.write(stream);
  return stream.str();
}

/// As liboctomap reads it.
std::unique_ptr<octomap::OcTree> read_back(const std::string& bt) {
  auto tree = std::make_unique<octomap::OcTree>(1.0);
  std::istringstream stream(bt);
  EXPECT_TRUE(tree->readBinary(stream));
  return tree;
}

octomap::OcTreeKey key_of(const OctreeLeaf& leaf) {
  const auto key = [&](int axis) {
    return static_cast<octomap::key_type>(leaf.low[static_cast<std::size_t>(axis)] + 32768);
  };
  return {key(0), key(1), key(2)};
}

void expect_same_leaves(const OctreeFile& ours, const octomap::OcTree& theirs) {
  std::size_t leaves = 0;
  ours.for_each_leaf([&](const OctreeLeaf& leaf) {
    ++leaves;
    int depth = 16;
    for (std::int32_t side = leaf.side; side > 1; side /= 2) --depth;
    const auto* node = theirs.search(key_of(leaf), static_cast<unsigned>(depth));
    ASSERT_NE(node, nullptr);
    EXPECT_FALSE(theirs.nodeHasChildren(node));
    EXPECT_EQ(theirs.isNodeOccupied(node), leaf.occupied);
  });
  EXPECT_EQ(leaves, theirs.getNumLeafNodes());
}

TEST(OctreeFile, HasTheLeavesOfTheFilesAndWritesTheSameFile) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    octomap::OcTree tree = random_tree(seed, 40);
    expect_same_leaves({ot_of(tree), "tree.ot"}, tree);
    const std::string bt = bt_of(tree);
    const OctreeFile ours(bt, "tree.bt");
    expect_same_leaves(ours, *read_back(bt));
    EXPECT_EQ(ours.bt_bytes(), bt);
    EXPECT_EQ(ours.resolution_m(), kResolution);
  }
}

TEST(OctreeFile, CoarserIsWhatInnerNodesSay) {
  const std::unique_ptr<octomap::OcTree> fine = read_back(bt_of(random_tree(3, 60)));
  const OctreeFile ours(bt_of(*fine), "tree.bt");
  for (const auto& [voxel_m, depth] : {std::pair{0.1, 15U}, {0.15, 15U}, {0.2, 14U}, {0.4, 13U}, {1.6, 11U}}) {
    const OctreeFile coarse = ours.coarsened(voxel_m);
    const std::unique_ptr<octomap::OcTree> read = read_back(coarse.bt_bytes());
    expect_same_leaves(coarse, *read);
    for (auto leaf = fine->begin_leafs(); leaf != fine->end_leafs(); ++leaf) {
      const auto* before = fine->search(leaf.getKey(), depth);
      const auto* after = read->search(leaf.getKey());
      ASSERT_NE(after, nullptr);
      EXPECT_EQ(fine->isNodeOccupied(before), read->isNodeOccupied(after)) << voxel_m;
    }
    coarse.for_each_leaf([&](const OctreeLeaf& leaf) { EXPECT_GE(leaf.side, 1 << (16 - depth)); });
  }
}

TEST(OctreeFile, CubesJoinToTheWhole) {
  for (const double voxel_m : {0.05, 0.2}) {
    const OctreeFile whole = OctreeFile(bt_of(random_tree(5, 60)), "tree.bt").coarsened(voxel_m);
    const auto cubes = whole.cubes();
    EXPECT_GT(cubes.size(), 4U);
    OctreeFile joined(cubes.begin()->second, "cube");
    for (const auto& [key, bytes] : cubes) {
      read_back(bytes);
      joined.join({bytes, key});
    }
    EXPECT_EQ(joined.bt_bytes(), whole.bt_bytes());
  }
}

TEST(OctreeFile, OfNothingIsEmpty) {
  const octomap::OcTree tree(kResolution);
  int leaves = 0;
  OctreeFile(bt_of(tree), "empty.bt").for_each_leaf([&](const OctreeLeaf&) { ++leaves; });
  OctreeFile(ot_of(tree), "empty.ot").for_each_leaf([&](const OctreeLeaf&) { ++leaves; });
  EXPECT_EQ(leaves, 0);
}

/// Read, or refused in one line that names the file.
void read_or_refuse(const std::string& bytes) {
  try {
    const OctreeFile tree(bytes, "hostile.bt");
    std::size_t leaves = 0;
    tree.for_each_leaf([&](const OctreeLeaf&) { ++leaves; });
    EXPECT_LE(leaves, 4 * bytes.size() + 8);
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).find("hostile.bt: "), 0U) << error.what();
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
  }
}

TEST(OctreeFile, SurvivesHostileFiles) {
  Random random(9);
  octomap::OcTree tree = random_tree(7, 10);
  for (const std::string& whole : {bt_of(tree), ot_of(tree)}) {
    for (int trial = 0; trial < 2000; ++trial) {
      std::string bad = whole.substr(0, trial % 3 == 0 ? random.below(whole.size()) : whole.size());
      for (std::uint64_t flips = random.below(6); flips > 0 && !bad.empty(); --flips) {
        bad[random.below(bad.size())] = static_cast<char>(random.below(256));
      }
      read_or_refuse(bad);
    }
    const std::size_t data = whole.find("data\n") + 5;
    read_or_refuse(whole.substr(0, data) + std::string(1'000'000, '\xFF'));  // Every node has eight below it.
    EXPECT_THROW(OctreeFile(whole.substr(0, data) + std::string(1'000'000, '\xFF'), "deep"), InputError);
  }
  for (const char* res : {"nan", "0", "-1", "inf", "1e-30", ""}) {
    EXPECT_THROW(
        OctreeFile(std::string("# Octomap OcTree binary file\nid OcTree\nsize 1\nres ") + res + "\ndata\n\0\0", "r"),
        InputError);
  }
}

}  // namespace
}  // namespace scanway::test
