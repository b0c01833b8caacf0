#include "modules/mapper/core/octomap/occupancy_tree.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <limits>
#include <string>

#include "common/random/random.h"
#include "tests/modules/mapper/core/octomap/support/reference.h"

namespace scanway {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

double between(Random& random, double low, double high) { return low + (high - low) * random.uniform(); }

/// Points on the walls and the floor of a room and some anywhere, seen from anywhere in it, at any place of the map.
MapPoints random_sweep(Random& random, const Eigen::Vector3d& centre, double side, int points) {
  MapPoints sweep;
  sweep.origin = centre + Eigen::Vector3d(random.normal(), random.normal(), random.normal()) * 0.1 * side;
  for (int i = 0; i < points; ++i) {
    Eigen::Vector3d p(between(random, -side, side), between(random, -side, side), between(random, -side, side));
    const std::uint64_t wall = random.below(8);
    if (wall < 6) p[wall / 2] = (wall % 2 == 0 ? side : -side) + 0.01 * random.normal();
    sweep.points.push_back((centre + p).cast<float>());
  }
  return sweep;
}

/// Three sweeps of one room; modes, resolutions and sizes change from seed to seed.
class RandomScenes : public ::testing::TestWithParam<int> {};

TEST_P(RandomScenes, AreThoseOfLiboctomap) {
  for (int scene = 0; scene < 35; ++scene) {
    Random random(static_cast<std::uint64_t>(GetParam() * 1000 + scene));
    const double resolution = std::array{0.1, 0.05, 0.02}[random.below(3)];
    const double side = resolution * between(random, 5.0, 45.0);
    const double far = scene % 4 == 0 ? 20000.0 * resolution : 30.0 * resolution;
    const Eigen::Vector3d centre(between(random, -far, far), between(random, -far, far), between(random, -far, far));
    const double max_range = scene % 3 == 0 ? side * between(random, 0.3, 1.2) : -1.0;
    std::vector<MapPoints> sweeps;
    for (int i = 0; i < 3; ++i) sweeps.push_back(random_sweep(random, centre, side, 300));
    const OccupancyTreeConfig config{resolution, max_range, scene % 2 == 0};
    const TreeFiles ours = files_of_ours(sweeps, config);
    ASSERT_TRUE(ours == files_of_liboctomap(sweeps, config)) << "scene " << scene << " resolution " << resolution;
    EXPECT_GT(ours.ot.size(), 1000u);
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomScenes, ::testing::Range(0, 6));

TEST(OccupancyTree, AThingSeenAgainAndAgainReachesTheBoundsAndComesBack) {
  Random random(5);
  std::vector<MapPoints> sweeps;
  const MapPoints room = random_sweep(random, {0.3, 0.2, 0.1}, 1.5, 2000);
  MapPoints bigger = room;
  for (Eigen::Vector3f& p : bigger.points) p *= 1.7f;
  for (int i = 0; i < 12; ++i) sweeps.push_back(i < 6 ? room : bigger);
  for (int i = 0; i < 12; ++i) sweeps.push_back(random_sweep(random, {0.3, 0.2, 0.1}, 1.5, 500));
  for (const bool discretize : {false, true}) {
    const OccupancyTreeConfig config{0.1, -1.0, discretize};
    EXPECT_TRUE(files_of_ours(sweeps, config) == files_of_liboctomap(sweeps, config));
  }
}

TEST(OccupancyTree, HostilePointsAreThoseOfLiboctomap) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const std::vector<Eigen::Vector3f> hostile = {
      {nan, 1.0f, 1.0f},      {1.0f, nan, nan},        {kInfinity, 0.0f, 0.0f},     {0.0f, -kInfinity, 1.0f},
      {1e30f, 1e30f, -1e30f}, {0.0f, 0.0f, 3e38f},     {4000.0f, 0.1f, 0.1f},       {-3276.8f, 0.0f, 0.0f},
      {3276.7f, 1.0f, 2.0f},  {3276.8f, 1.0f, 2.0f},   {1.0f, -3276.75f, 3276.75f}, {0.25f, 0.25f, 0.25f},
      {0.3f, 0.25f, 0.25f},   {0.25f, 0.25f, 2.0f},    {1e-30f, -1e-30f, 0.25f},    {2e9f, 0.0f, 0.0f},
      {5.0f, 5.0f, 5.0f},     {-0.0f, 0.25f, -7.3f},   {1e19f, 2.0f, 2.0f},         {0.1f, 0.1f, 0.1f},
      {2.5f, 2.5f, 2.5f},     {0.25f, -9.75f, 10.25f}, {-20.0f, -20.0f, -20.0f},    {214748364.7f, 1.0f, 1.0f}};
  for (const Eigen::Vector3d& origin :
       {Eigen::Vector3d(0.25, 0.25, 0.25), Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(0.1, 0.2, 0.3),
        Eigen::Vector3d(3276.75, 0, 0), Eigen::Vector3d(4000, 0, 0), Eigen::Vector3d(NAN, 0, 0)}) {
    for (const double max_range : {-1.0, 4.0, 5000.0}) {
      for (const bool discretize : {false, true}) {
        MapPoints sweep;
        sweep.points = hostile;
        sweep.origin = origin;
        const OccupancyTreeConfig config{0.1, max_range, discretize};
        EXPECT_TRUE(files_of_ours({sweep, sweep}, config) == files_of_liboctomap({sweep, sweep}, config))
            << origin.transpose() << ", " << max_range << ", " << discretize;
      }
    }
  }
}

TEST(OccupancyTree, NothingSeenIsAnEmptyTree) {
  EXPECT_TRUE(files_of_ours({MapPoints{}}, {}) == files_of_liboctomap({MapPoints{}}, {}));
}

TEST(OccupancyTree, AnyNumberOfThreadsGivesTheSame) {
  Random random(9);
  const std::vector<MapPoints> sweeps = {random_sweep(random, {1, 2, 3}, 2.0, 200'000),
                                         random_sweep(random, {1, 2, 3}, 2.5, 200'000)};
  const OccupancyTreeConfig config{0.05, 3.0, false};
  std::vector<TreeFiles> files;
  for (const std::size_t threads : {1, 2, 5}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    files.push_back(files_of_ours(sweeps, config));
  }
  EXPECT_TRUE(files[0] == files[1]);
  EXPECT_TRUE(files[0] == files[2]);
}

}  // namespace
}  // namespace scanway
