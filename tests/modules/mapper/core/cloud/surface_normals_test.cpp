#include <cmath>
#include <functional>
#include <map>
#include <tuple>

#include <gtest/gtest.h>
#include <Eigen/Eigenvalues>

#include "common/random/random.h"
#include "modules/mapper/core/cloud/plane_fit.h"
#include "modules/mapper/core/cloud/voxel_cloud.h"

namespace scanway {
namespace {

constexpr double kNoise = 0.005;  // metres

Eigen::Vector3d random_direction(Random& random) {
  return Eigen::Vector3d(random.normal(), random.normal(), random.normal()).normalized();
}

/// A plate of 2 m about `centre`, across `normal`, seen from 3 m away.
MapPoints plate(const Eigen::Vector3d& centre, const Eigen::Vector3d& normal, std::uint64_t seed) {
  Random random(seed);
  const Eigen::Vector3d u = normal.unitOrthogonal(), v = normal.cross(u);
  MapPoints points;
  points.origin = centre + 3.0 * normal + u;
  for (int i = 0; i < 20000; ++i) {
    const Eigen::Vector3d p = centre + u * (2.0 * random.uniform() - 1.0) + v * (2.0 * random.uniform() - 1.0) +
                              normal * kNoise * random.normal();
    points.points.push_back(p.cast<float>());
  }
  return points;
}

PointCloud cloud_of(const MapPoints& points) {
  VoxelCloud cloud(0.01);
  cloud.put(0, points);
  return cloud.centroids();
}

/// The share of points whose normal is within `degrees` of what is expected there.
double share_within(double degrees, const PointCloud& cloud,
                    const std::function<Eigen::Vector3d(const Eigen::Vector3d&)>& expected) {
  std::size_t right = 0;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const double cosine = cloud.normals[i].cast<double>().dot(expected(cloud.points[i].cast<double>()));
    right += cosine > std::cos(degrees * M_PI / 180.0) ? 1 : 0;
  }
  return static_cast<double>(right) / static_cast<double>(cloud.size());
}

TEST(PlaneFit, IsThatOfEigensSolver) {
  Random random(5);
  for (int i = 0; i < 2000; ++i) {
    const Eigen::Vector3d normal = random_direction(random), u = normal.unitOrthogonal(), v = normal.cross(u);
    const double flat = std::pow(10.0, -4.0 * random.uniform()), offset = 100.0 * random.uniform();
    Moments moments;
    std::vector<Eigen::Vector3d> points;
    for (int n = 0; n < 30; ++n) {
      points.push_back(Eigen::Vector3d(offset, 0.0, -offset) + u * 20.0 * random.normal() + v * 5.0 * random.normal() +
                       normal * flat * random.normal());
      moments.add(points.back());
    }
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& p : points) mean += p / 30.0;
    for (const Eigen::Vector3d& p : points) covariance += (p - mean) * (p - mean).transpose() / 30.0;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
    const PlaneFit fit = fit_plane(moments);
    EXPECT_NEAR(std::fabs(fit.normal.dot(solver.eigenvectors().col(0))), 1.0, 1e-6);
    EXPECT_NEAR(fit.across * 27.0 / 30.0, solver.eigenvalues()[0], 1e-6);
    EXPECT_NEAR(fit.along, solver.eigenvalues()[1], 1e-4);
    EXPECT_NEAR((fit.mean - mean).norm(), 0.0, 1e-9);
  }
}

TEST(SurfaceNormals, OfPlatesAnywhereThatAreSeenFromAnySide) {
  Random random(1);
  for (std::uint64_t i = 0; i < 20; ++i) {
    const Eigen::Vector3d normal = random_direction(random), centre = 50.0 * random_direction(random);
    const PointCloud cloud = cloud_of(plate(centre, normal, i));
    ASSERT_EQ(cloud.normals.size(), cloud.size());
    EXPECT_GT(share_within(5.0, cloud, [&](const Eigen::Vector3d&) { return normal; }), 0.98);
  }
}

TEST(SurfaceNormals, OfABallFollowItsCurve) {
  Random random(2);
  MapPoints points;
  points.origin = {0.0, 0.0, 0.0};  // in a round room of 2 m: the normals look inwards
  for (int i = 0; i < 200000; ++i) points.points.push_back((2.0 * random_direction(random)).cast<float>());
  const auto inwards = [](const Eigen::Vector3d& p) { return Eigen::Vector3d(-p.normalized()); };
  EXPECT_GT(share_within(15.0, cloud_of(points), inwards), 0.98);
}

TEST(SurfaceNormals, OfACornerAreOfItsTwoWalls) {
  Random random(3);
  MapPoints points;
  points.origin = {1.5, 1.5, 0.3};
  for (int i = 0; i < 60000; ++i) {
    const double along = 2.0 * random.uniform(), up = random.uniform();
    points.points.push_back(i % 2 == 0 ? Eigen::Vector3f(along, 0.0, up) : Eigen::Vector3f(0.0, along, up));
  }
  const auto of_wall = [](const Eigen::Vector3d& p) {
    return p.x() > p.y() ? Eigen::Vector3d(Eigen::Vector3d::UnitY()) : Eigen::Vector3d(Eigen::Vector3d::UnitX());
  };
  EXPECT_GT(share_within(5.0, cloud_of(points), of_wall), 0.95);
}

TEST(SurfaceNormals, ScatterAndSingleLinesHaveNone) {
  Random random(4);
  MapPoints points;
  for (int i = 0; i < 3000; ++i) {
    const auto across = [&random] { return 1.28 * random.uniform(); };  // whole cubes: a slab of them is a surface
    points.points.emplace_back(across(), across(), across());
    points.points.emplace_back(10.0 + 2.0 * random.uniform(), 0.003 * random.normal(), 0.003 * random.normal());
  }
  const PointCloud cloud = cloud_of(points);
  std::size_t without = 0;
  for (const Eigen::Vector3f& normal : cloud.normals) without += normal.isZero() ? 1 : 0;
  EXPECT_GT(static_cast<double>(without), 0.95 * static_cast<double>(cloud.size()));
}

TEST(SurfaceNormals, OfTwoSweepsAreWeighedByTheirPoints) {
  // Three points seen from above, then one seen from below, in a cube of points that make the surface.
  MapPoints above, below;
  above.origin = {0.05, 0.05, 5.0};
  below.origin = {0.05, 0.05, -5.0};
  for (int x = 0; x < 8; ++x) {
    for (int y = 0; y < 8; ++y) {
      const Eigen::Vector3f p(0.01f * x + 0.005f, 0.01f * y + 0.005f, 0.005f);
      for (int n = 0; n < 3; ++n) above.points.push_back(p);
      below.points.push_back(p);
    }
  }
  VoxelCloud cloud(0.01);
  cloud.put(0, above);
  cloud.put(1, below);
  for (const Eigen::Vector3f& normal : cloud.centroids().normals) EXPECT_EQ(normal, Eigen::Vector3f::UnitZ());
  cloud.withdraw(0);
  for (const Eigen::Vector3f& normal : cloud.centroids().normals) EXPECT_EQ(normal, -Eigen::Vector3f::UnitZ());
  cloud.put(2, below);
  cloud.put(3, above);
  cloud.withdraw(2);
  for (const Eigen::Vector3f& normal : cloud.centroids().normals) EXPECT_EQ(normal, Eigen::Vector3f::UnitZ());
}

}  // namespace
}  // namespace scanway
