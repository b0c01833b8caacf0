// What is compiled for one kind of CPU marks the voxels that the plain code marks, and these are liboctomap's.
#include "modules/mapper/core/octomap/ray_lanes.h"

#include <gtest/gtest.h>
#include <octomap/OcTree.h>

#include <cstring>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include "common/random/random.h"
#include "modules/mapper/core/octomap/key_ray.h"

namespace scanway {
namespace {

struct Ends {
  octomap::point3d origin;
  std::vector<octomap::point3d> points;
};

/// Ends all about an origin, short and long, some along the axes.
Ends random_ends(Random& random) {
  const auto anywhere = [&random](double reach) { return static_cast<float>((2.0 * random.uniform() - 1.0) * reach); };
  Ends ends{{anywhere(20.0), anywhere(20.0), anywhere(3.0)}, {}};
  for (int i = 0; i < 500; ++i) {
    const double reach = i % 3 == 0 ? 0.3 : 25.0;
    octomap::point3d beam(anywhere(reach), anywhere(reach), anywhere(reach));
    if (i % 10 == 0) beam = {beam.x(), 0.0f, 0.0f};
    if (i % 10 == 1) beam = {beam.x(), beam.y(), 0.0f};
    if (i % 10 == 2) beam = {beam.x(), beam.x(), -beam.x()};
    ends.points.push_back(ends.origin + beam);
  }
  return ends;
}

std::set<MortonCode> voxels_by(const RayLanes::Variant& variant, const Ends& ends, const KeyGrid& grid) {
  VoxelBricks bricks;
  RayLanes lanes(bricks, variant);
  const KeyRays rays(grid, ends.origin);
  for (const octomap::point3d& end : ends.points) {
    KeyRay ray;
    if (rays.start(end, ray)) lanes.add(ray);
  }
  lanes.finish();
  std::set<MortonCode> voxels;
  for (const VoxelBricks::BrickNumber number : bricks.numbers()) {
    const VoxelBrick& brick = bricks.at(number);
    for (std::size_t bit = 0; bit < 64 * kBrickWords; ++bit) {
      if (brick.free[bit / 64] >> (bit % 64) & 1) voxels.insert(number << kBrickBits | bit);
    }
  }
  return voxels;
}

/// All voxels along the rays but the first and the last of each.
std::set<MortonCode> voxels_by_liboctomap(const Ends& ends, double resolution) {
  const octomap::OcTree tree(resolution);
  std::set<MortonCode> voxels;
  octomap::KeyRay keys;
  for (const octomap::point3d& end : ends.points) {
    if (!tree.computeRayKeys(ends.origin, end, keys) || keys.size() == 0) continue;
    for (auto key = keys.begin() + 1; key < keys.end(); ++key) voxels.insert(morton_code(*key));
  }
  return voxels;
}

TEST(RayLanes, EveryVariantMarksTheVoxelsOfLiboctomap) {
  std::string cpus;
  for (const RayLanes::Variant& variant : RayLanes::variants()) cpus += std::string(variant.cpu) + " ";
  RecordProperty("variants", cpus);
  ASSERT_EQ(RayLanes::variants().back().cpu, "any");
  Random random(8);
  for (const double resolution : {0.1, 0.05, 0.02}) {
    for (int scene = 0; scene < 2; ++scene) {
      const Ends ends = random_ends(random);
      const std::set<MortonCode> expected = voxels_by_liboctomap(ends, resolution);
      EXPECT_GT(expected.size(), 10'000u);
      for (const RayLanes::Variant& variant : RayLanes::variants()) {
        EXPECT_TRUE(voxels_by(variant, ends, KeyGrid(resolution)) == expected) << variant.cpu << ", " << resolution;
      }
    }
  }
}

/// Step by step, with borders that are equal or endless.
TEST(RayLanes, EveryVariantStepsTheSameBits) {
  const double endless = std::numeric_limits<double>::max();
  constexpr std::size_t kSteps = RayLanes::kStepsAtOnce;
  Random random(9);
  for (int round = 0; round < 200; ++round) {
    RayLanes::State start{};
    for (std::size_t lane = 0; lane < RayLanes::kLanes; ++lane) {
      for (int axis = 0; axis < 3; ++axis) {
        const std::uint64_t kind = random.below(6);
        start.border_m[axis][lane] = kind == 0 ? endless : kind == 1 ? 0.5 : random.uniform();
        start.between_m[axis][lane] = kind == 0 ? endless : kind == 1 ? 0.25 : random.uniform();
      }
      start.code[lane] = random.below(std::uint64_t{1} << 48);
      start.mirror[lane] = random.below(2) * kAxisBits[random.below(3)];
      start.word[lane] = (start.code[lane] ^ start.mirror[lane]) / 64;
    }
    for (const RayLanes::Variant& variant : RayLanes::variants()) {
      RayLanes::State state = start, stepped = start;
      for (int part = 0; part < 3; ++part) {
        RayLanes::Passed first, other;
        std::memset(&first, 0, sizeof(first));
        std::memset(&other, 0, sizeof(other));
        RayLanes::variants().back().step_all(state, kSteps, first);
        variant.step_all(stepped, kSteps, other);
        EXPECT_EQ(std::memcmp(&first, &other, sizeof(first)), 0) << variant.cpu;
        EXPECT_EQ(std::memcmp(&state, &stepped, sizeof(state)), 0) << variant.cpu;
      }
    }
  }
}

}  // namespace
}  // namespace scanway
