#include "modules/mapper/core/registration/cell_grid.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include <gtest/gtest.h>

#include "modules/mapper/core/registration/neighbourhoods.h"
#include "modules/mapper/core/registration/voxel_grid.h"
#include "tests/modules/mapper/core/registration/random_points.h"

namespace scanway::registration {
namespace {

std::vector<std::uint32_t> brute_within(const Points& points, const Eigen::Vector3f& query, float radius) {
  std::vector<std::uint32_t> found;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    if ((points[i] - query).squaredNorm() <= radius * radius) found.push_back(i);
  }
  return found;
}

TEST(CellGrid, FindsWhatBruteForceFindsAtEveryRatioOfRadiusToCell) {
  Random random(3);
  for (const float radius : {0.2f, 0.7f, 2.3f}) {
    const Points points = random_points(random, 2000, 5.0f);
    const CellGrid grid(points, 0.7f);
    for (int k = 0; k < 200; ++k) {
      const Eigen::Vector3f query = random_point(random, 6.0f);
      std::vector<std::uint32_t> found;
      grid.for_each_within(query, radius, [&](std::uint32_t i, float) { found.push_back(grid.original()[i]); });
      std::sort(found.begin(), found.end());
      EXPECT_EQ(found, brute_within(points, query, radius));
      EXPECT_EQ(grid.any_within(query, radius), !found.empty());
    }
  }
}

TEST(CellGrid, NearestIsTheNearestOfBruteForce) {
  Random random(4);
  const Points points = random_points(random, 3000, 5.0f);
  const CellGrid grid(points, 0.5f);
  for (int k = 0; k < 500; ++k) {
    const Eigen::Vector3f query = random_point(random, 6.0f);
    float best = 1.2f * 1.2f;
    for (const Eigen::Vector3f& p : points) best = std::min(best, (p - query).squaredNorm());
    const CellGrid::Nearest nearest = grid.nearest(query, 1.2f);
    EXPECT_EQ(nearest.found(), best < 1.2f * 1.2f);
    if (nearest.found()) {
      EXPECT_EQ(nearest.squared_distance, best);
    }
  }
}

TEST(CellGrid, HostileQueriesAndPointsFindNothing) {
  const float nan = std::nanf("");
  const CellGrid empty(Points{}, 0.5f);
  EXPECT_FALSE(empty.nearest({0, 0, 0}, 1.0f).found());
  const CellGrid grid({{nan, 0, 0}, {1, 2, 3}, {1e30f, 0, 0}, {1, 2, 3}}, 0.5f);
  EXPECT_EQ(grid.size(), 2u);
  EXPECT_FALSE(grid.any_within({nan, 2, 3}, 1.0f));
  EXPECT_FALSE(grid.any_within({1e30f, 2, 3}, 1.0f));
  EXPECT_TRUE(grid.any_within({1, 2, 3}, 0.0f));
}

TEST(Neighbourhoods, HoldEveryNeighbourButThePointItself) {
  Random random(5);
  const CellGrid grid(random_points(random, 1500, 3.0f), 0.4f);
  const Neighbourhoods all = find_neighbourhoods(grid, 0.6f);
  ASSERT_EQ(all.begin.size(), grid.size() + 1);
  for (std::uint32_t i = 0; i < grid.size(); ++i) {
    std::vector<std::uint32_t> expected = brute_within(grid.points(), grid.points()[i], 0.6f);
    std::erase(expected, i);
    std::vector<std::uint32_t> found(all.of(i).begin(), all.of(i).end());
    std::sort(found.begin(), found.end());
    EXPECT_EQ(found, expected);
  }
}

TEST(VoxelGrid, CentroidsOfBruteForceInOrderOfTheVoxels) {
  Random random(6);
  for (const float extent : {0.5f, 20.0f, 900.0f}) {
    const Points points = random_points(random, 5000, extent);
    std::map<std::tuple<int, int, int>, std::pair<Eigen::Vector3d, int>> voxels;
    for (const Eigen::Vector3f& p : points) {
      const Eigen::Vector3f s = p * (1.0f / 0.3f);
      auto& [sum, count] = voxels
                               .try_emplace({static_cast<int>(std::floor(s.z())), static_cast<int>(std::floor(s.y())),
                                             static_cast<int>(std::floor(s.x()))},
                                            Eigen::Vector3d::Zero(), 0)
                               .first->second;
      sum += p.cast<double>();
      ++count;
    }
    const Points centroids = voxel_centroids(points, 0.3f);
    ASSERT_EQ(centroids.size(), voxels.size());
    std::size_t i = 0;
    for (const auto& [key, voxel] : voxels) {
      const Eigen::Vector3f expected = (voxel.first / voxel.second).cast<float>();
      EXPECT_LT((centroids[i++] - expected).norm(), 1e-4f);
    }
  }
}

TEST(VoxelGrid, OneCentimetreOverAKilometreKeepsEveryPlace) {
  Points points;
  for (int i = 0; i < 1000; ++i) points.push_back({static_cast<float>(i) - 500.0f, 0.005f, 0.005f});
  EXPECT_EQ(voxel_centroids(points, 0.01f).size(), 1000u);
  EXPECT_EQ(voxel_centroids({}, 0.01f).size(), 0u);
  EXPECT_EQ(voxel_centroids({{std::nanf(""), 0, 0}}, 0.01f).size(), 0u);
}

}  // namespace
}  // namespace scanway::registration
