#include "modules/mapper/core/cloud/voxel_cloud.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>

#include <gtest/gtest.h>

#include "common/random/random.h"

namespace scanway {
namespace {

MapPoints random_points(std::size_t n, double extent, std::uint64_t seed, bool with_intensity = true) {
  Random random(seed);
  MapPoints points;
  for (std::size_t i = 0; i < n; ++i) {
    // a few clusters, so that voxels hold many points, and a wide scatter
    const double size = i % 2 == 0 ? 0.1 : extent;
    points.points.emplace_back((random.uniform() - 0.5) * size, (random.uniform() - 0.5) * size,
                               (random.uniform() - 0.5) * size);
    if (with_intensity) points.intensity.push_back(static_cast<float>(random.uniform() * 255.0));
  }
  return points;
}

bool same_bytes(const PointCloud& a, const PointCloud& b) {
  return a.size() == b.size() && a.intensity.size() == b.intensity.size() && a.normals == b.normals &&
         std::memcmp(a.points.data(), b.points.data(), a.size() * sizeof(a.points[0])) == 0 &&
         std::memcmp(a.intensity.data(), b.intensity.data(), a.intensity.size() * sizeof(float)) == 0;
}

MapPoints shuffled(const MapPoints& points, std::uint64_t seed) {
  MapPoints result = points;
  Random random(seed);
  for (std::size_t i = result.points.size(); i > 1; --i) {
    const std::size_t j = random.below(i);
    std::swap(result.points[i - 1], result.points[j]);
    if (!result.intensity.empty()) std::swap(result.intensity[i - 1], result.intensity[j]);
  }
  return result;
}

struct Mean {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double intensity = 0.0;
  int count = 0;
};

TEST(VoxelCloud, CentroidsAreThoseOfABruteForceMap) {
  constexpr double kVoxel = 0.01;
  const MapPoints points = random_points(20000, 40.0, 3);
  VoxelCloud cloud(kVoxel);
  cloud.put(0, points);
  std::map<std::array<long, 3>, Mean> expected;
  for (std::size_t i = 0; i < points.points.size(); ++i) {
    std::array<long, 3> key{};
    // a coordinate belongs to the voxel of its nearest 1024th, as the header says
    for (std::size_t k = 0; k < 3; ++k) {
      const double fixed = std::floor(points.points[i][static_cast<int>(k)] * 1024.0 / kVoxel + 0.5);
      key[k] = static_cast<long>(std::floor(fixed / 1024.0));
    }
    Mean& mean = expected[key];
    mean.sum += points.points[i].cast<double>();
    mean.intensity += points.intensity[i];
    ++mean.count;
  }
  const PointCloud centroids = cloud.centroids();
  ASSERT_EQ(centroids.size(), expected.size());
  ASSERT_EQ(centroids.intensity.size(), expected.size());
  for (const auto& [key, voxel] : expected) {
    const Eigen::Vector3d mean = voxel.sum / voxel.count;
    const auto is_near = [&](const Eigen::Vector3f& p) {
      return (p.cast<double>() - mean).cwiseAbs().maxCoeff() < 5e-6 + 2e-6;  // floats at 20 m are 2e-6 apart
    };
    const auto found = std::find_if(centroids.points.begin(), centroids.points.end(), is_near);
    ASSERT_NE(found, centroids.points.end()) << mean.transpose();
    EXPECT_NEAR(centroids.intensity[static_cast<std::size_t>(found - centroids.points.begin())],
                voxel.intensity / voxel.count, 1.0 / 256.0);
  }
}

TEST(VoxelCloud, TheOrderOfPointsAndSweepsDoesNotMatter) {
  const MapPoints first = random_points(30000, 30.0, 1), second = random_points(20000, 60.0, 2);
  VoxelCloud a(0.01), b(0.01);
  a.put(0, first);
  a.put(1, second);
  b.put(0, shuffled(second, 9));
  b.put(1, shuffled(first, 8));
  EXPECT_TRUE(same_bytes(a.centroids(), b.centroids()));
  EXPECT_GT(a.size(), 20000u);
}

TEST(VoxelCloud, AFlatGroundOnTheBordersOfCubesIsWholeInAnyOrder) {
  Random random(6);
  MapPoints ground;
  ground.origin = {0.0, 0.0, 1.4};
  for (int line = 0; line < 200; ++line) {
    for (int beam = 0; beam < 200; ++beam) {
      ground.points.emplace_back(0.02 * line - 2.0, 0.02 * beam - 2.0, 0.005 * random.normal());
      ground.intensity.push_back(static_cast<float>(random.below(256)));
    }
  }
  ground.points[77] = {0.0f, std::numeric_limits<float>::quiet_NaN(), 0.0f};
  VoxelCloud in_lines(0.01), anyhow(0.01);
  in_lines.put(0, ground);
  anyhow.put(0, shuffled(ground, 7));
  EXPECT_TRUE(same_bytes(in_lines.centroids(), anyhow.centroids()));
  EXPECT_EQ(in_lines.points_out_of_extent(), 1u);
}

TEST(VoxelCloud, KilometresApartIsNoOverflow) {
  MapPoints points;
  points.points = {{4000.0f, -4000.0f, 100.0f}, {-4000.0f, 4000.0f, -100.0f}, {4000.001f, -4000.0f, 100.0f}};
  VoxelCloud cloud(0.01);
  cloud.put(0, points);
  EXPECT_EQ(cloud.points_out_of_extent(), 0u);
  for (const Eigen::Vector3f& p : cloud.centroids().points) EXPECT_NEAR(std::fabs(p.x()), 4000.0, 0.02);
}

TEST(VoxelCloud, WhatIsNotFiniteOrTooFarIsLeftOutAndCounted) {
  MapPoints points;
  const float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
  points.points = {{nan, 0, 0}, {0, infinity, 0}, {0, 0, -infinity}, {1e9f, 0, 0}, {1, 2, 3}};
  VoxelCloud cloud(0.01);
  cloud.put(0, points);
  EXPECT_EQ(cloud.size(), 1u);
  EXPECT_EQ(cloud.points_out_of_extent(), 4u);
}

TEST(VoxelCloud, NoIntensityInNoIntensityOut) {
  VoxelCloud cloud(0.01);
  cloud.put(0, random_points(100, 1.0, 5, false));
  EXPECT_TRUE(cloud.centroids().intensity.empty());
}

TEST(VoxelCloud, AnEmptyCloudIsEmpty) {
  VoxelCloud cloud(0.01);
  cloud.put(0, {});
  EXPECT_TRUE(cloud.centroids().empty());
}

TEST(PointsInMap, OnlyFinitePointsWithinRangeAndTheirIntensity) {
  Sweep sweep;
  const float nan = std::numeric_limits<float>::quiet_NaN();
  sweep.cloud.points = {{0.1f, 0, 0}, {1, 0, 0}, {nan, 0, 0}, {0, 90, 0}, {0, 0, 2}};
  sweep.cloud.intensity = {1, 2, 3, 4, 5};
  Pose X = Pose::Identity();
  X.translation() = Eigen::Vector3d(10, 20, 30);
  const MapPoints points = points_in_map(sweep, X, 0.3, 80.0);
  ASSERT_EQ(points.points.size(), 2u);
  EXPECT_EQ(points.points[0], Eigen::Vector3f(11, 20, 30));
  EXPECT_EQ(points.points[1], Eigen::Vector3f(10, 20, 32));
  EXPECT_EQ(points.intensity, (std::vector<float>{2, 5}));
}

TEST(VoxelCloud, ASweepThatIsWithdrawnOrMovedLeavesNothing) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (const bool with_intensity : {false, true}) {
    const MapPoints a = random_points(5000, 3.0, 1), c = random_points(5000, 2.0, 3);
    MapPoints b = random_points(5000, 3.0, 2, with_intensity);
    b.points[7] = {nan, 0.0f, 0.0f};
    VoxelCloud never(0.01), taken(0.01);
    taken.put(0, random_points(5000, 8.0, 4));
    taken.put(1, b);
    taken.put(2, c);
    taken.put(0, a);
    never.put(0, a);
    never.put(1, c);
    taken.withdraw(1);
    EXPECT_TRUE(same_bytes(taken.centroids(), never.centroids()));
    EXPECT_EQ(taken.points_out_of_extent(), 0u);
    EXPECT_THROW(taken.withdraw(1), std::invalid_argument);
  }
}

TEST(VoxelCloud, ItsTilesAreAllOfIt) {
  VoxelCloud cloud(0.01);
  cloud.put(0, random_points(5000, 30.0, 1));
  cloud.put(1, random_points(5000, 40.0, 2, false));
  PointCloud together;
  for (const VoxelCloud::TileNumber tile : cloud.tiles()) {
    PointCloud part = cloud.centroids_of(tile);
    part.intensity.resize(part.points.size());  // A tile that only the second sweep touched has none.
    together.points.insert(together.points.end(), part.points.begin(), part.points.end());
    together.normals.insert(together.normals.end(), part.normals.begin(), part.normals.end());
    together.intensity.insert(together.intensity.end(), part.intensity.begin(), part.intensity.end());
  }
  EXPECT_GT(cloud.tiles().size(), 20u);
  EXPECT_TRUE(same_bytes(together, cloud.centroids()));
  EXPECT_EQ(cloud.size(), together.size());
  EXPECT_GT(cloud.size(), cloud.centroids(1).size());
}

}  // namespace
}  // namespace scanway
