#include "modules/mapper/core/ground/ground_plane.h"

#include <cmath>

#include <gtest/gtest.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/segmentation/sac_segmentation.h>

#include "common/geometry/pose.h"
#include "common/random/random.h"

namespace scanway {
namespace {

/// A made-up place, seen from (0, 0, 0): its floor at the height below, tilted by the slopes.
struct Place {
  double floor = -1.2;
  double slope_x = 0.0, slope_y = 0.0;
  double noise = 0.0;
  Random random{1};
  MapPoints points{};

  void add(double x, double y, double z) {
    points.points.push_back((Eigen::Vector3d(x, y, z + noise * random.normal())).cast<float>());
  }
  double between(double low, double high) { return low + (high - low) * random.uniform(); }
  void add_horizontal(double x0, double x1, double y0, double y1, double above_floor, int count) {
    for (int i = 0; i < count; ++i) {
      const double x = between(x0, x1), y = between(y0, y1);
      add(x, y, floor + slope_x * x + slope_y * y + above_floor);
    }
  }
  void add_wall(double x, int count) {
    for (int i = 0; i < count; ++i) add(x, between(-8, 8), floor + between(0, 2.5));
  }
};

Place hall(double noise, double slope_x = 0.0) {
  Place place;
  place.noise = noise;
  place.slope_x = slope_x;
  place.add_horizontal(-8, 8, -8, 8, 0.0, 12000);
  place.add_horizontal(-8, 8, -8, 8, 2.4, 20000);  // the ceiling shows more than the floor
  place.add_wall(-8, 6000);
  place.add_wall(8, 6000);
  place.add_horizontal(1, 3, 1, 3, 0.75, 6000);  // a densely scanned table
  return place;
}

void expect_ground(const Place& place, double height_tolerance, double slope_tolerance) {
  const auto ground = find_ground_plane(place.points, {});
  ASSERT_TRUE(ground.has_value());
  EXPECT_NEAR(ground->height_m, place.floor, height_tolerance);
  EXPECT_NEAR(ground->slope_x, place.slope_x, slope_tolerance);
  EXPECT_NEAR(ground->slope_y, place.slope_y, slope_tolerance);
}

TEST(GroundPlane, FloorAndNotCeilingOrTable) { expect_ground(hall(0.0), 1e-4, 1e-4); }
TEST(GroundPlane, WithRangeNoise) { expect_ground(hall(0.01), 0.002, 0.001); }
TEST(GroundPlane, TiltedByTenDegrees) { expect_ground(hall(0.01, std::tan(0.1745)), 0.003, 0.001); }

TEST(GroundPlane, ATableThatHidesTheFloorAroundTheRobotIsNoGround) {
  Place place;
  place.noise = 0.005;
  place.add_horizontal(-2, 2, -2, 2, 0.75, 9000);
  place.add_horizontal(-6, -2, -6, 6, 0.0, 3000);
  place.add_horizontal(2, 6, -6, 6, 0.0, 3000);
  expect_ground(place, 0.002, 0.001);
}

TEST(GroundPlane, ADockThatTheRobotStandsOnBeatsTheYardBelow) {
  Place place;
  place.add_horizontal(-4, 4, -4, 4, 0.0, 9000);
  place.add_horizontal(4, 14, -10, 10, -1.1, 9000);
  expect_ground(place, 1e-3, 1e-3);
}

TEST(GroundPlane, MirrorImagesBelowTheFloorDoNotCount) {
  Place place = hall(0.005);
  place.add_horizontal(-8, 8, -8, 8, -2.4, 1500);
  expect_ground(place, 0.002, 0.001);
}

TEST(GroundPlane, NoGroundIsAnAnswer) {
  Place walls;
  walls.add_wall(-4, 5000);
  walls.add_wall(4, 5000);
  EXPECT_FALSE(find_ground_plane(walls.points, {}).has_value());
  Place ceiling;
  ceiling.add_horizontal(-8, 8, -8, 8, 3.0, 9000);
  EXPECT_FALSE(find_ground_plane(ceiling.points, {}).has_value());
  Place steep;
  steep.slope_x = 0.6;
  steep.add_horizontal(-2, 2, -8, 8, -0.5, 9000);
  EXPECT_FALSE(find_ground_plane(steep.points, {}).has_value());
  EXPECT_FALSE(find_ground_plane({}, {}).has_value());
  Place scatter;
  for (int i = 0; i < 3000; ++i) scatter.add(scatter.between(-9, 9), scatter.between(-9, 9), scatter.between(-3, 3));
  EXPECT_FALSE(find_ground_plane(scatter.points, {.min_area_m2 = 20.0}).has_value());
}

TEST(GroundPlane, TheSensorsHeightRulesOtherSurfacesOut) {
  const Place place = hall(0.005);
  EXPECT_TRUE(find_ground_plane(place.points, {.sensor_height_m = 1.25}).has_value());
  EXPECT_FALSE(find_ground_plane(place.points, {.min_area_m2 = 10.0, .sensor_height_m = 0.5}).has_value());
}

TEST(GroundPlane, AgreesWithPclOnManyPlaces) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Random random(seed);
    Place place;
    place.random = Random(seed + 100);
    place.noise = 0.008;
    place.floor = -0.6 - random.uniform();
    place.slope_x = 0.2 * (random.uniform() - 0.5);
    place.slope_y = 0.2 * (random.uniform() - 0.5);
    place.add_horizontal(-7, 7, -7, 7, 0.0, 12000);
    place.add_wall(6, 3000);

    pcl::PointCloud<pcl::PointXYZ>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZ>);
    for (const Eigen::Vector3f& p : place.points.points) cloud->push_back({p.x(), p.y(), p.z()});
    pcl::SACSegmentation<pcl::PointXYZ> segmentation;
    segmentation.setModelType(pcl::SACMODEL_PERPENDICULAR_PLANE);
    segmentation.setAxis(Eigen::Vector3f::UnitZ());
    segmentation.setEpsAngle(0.2618);
    segmentation.setMethodType(pcl::SAC_RANSAC);
    segmentation.setDistanceThreshold(0.03);
    segmentation.setMaxIterations(1000);
    segmentation.setOptimizeCoefficients(true);
    segmentation.setInputCloud(cloud);
    pcl::PointIndices inliers;
    pcl::ModelCoefficients plane;
    segmentation.segment(inliers, plane);
    ASSERT_EQ(plane.values.size(), 4u);

    const auto ground = find_ground_plane(place.points, {});
    ASSERT_TRUE(ground.has_value());
    for (const Eigen::Vector2d& at : {Eigen::Vector2d(0, 0), Eigen::Vector2d(5, 5), Eigen::Vector2d(-5, 5)}) {
      const double theirs = -(plane.values[0] * at.x() + plane.values[1] * at.y() + plane.values[3]) / plane.values[2];
      EXPECT_NEAR(ground->height_at(at.x(), at.y()), theirs, 0.005) << seed;
    }
  }
}

TEST(GroundPlane, TheSameEveryTime) {
  const Place place = hall(0.01);
  const auto a = find_ground_plane(place.points, {}), b = find_ground_plane(place.points, {});
  EXPECT_EQ(a->height_m, b->height_m);
  EXPECT_EQ(a->slope_x, b->slope_x);
}

}  // namespace
}  // namespace scanway
