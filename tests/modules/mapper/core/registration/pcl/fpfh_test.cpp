#include "modules/mapper/core/registration/fpfh.h"

#include <cmath>

#include <gtest/gtest.h>
#include <pcl/features/fpfh.h>
#include <pcl/features/normal_3d.h>
#include <pcl/search/kdtree.h>

#include "modules/mapper/core/registration/voxel_grid.h"
#include "tests/modules/mapper/core/registration/random_points.h"

namespace scanway::registration {
namespace {

constexpr float kRadius = 0.9f;

struct Ours {
  CellGrid grid;
  Neighbourhoods neighbourhoods;
  Normals normals;
};

/// A room with noise, so that no angle lies on the border of two bins by construction.
Ours prepare() {
  Random random(21);
  Points points = room(0.15f);
  for (Eigen::Vector3f& p : points) p += random_point(random, 0.02f);
  Ours ours;
  ours.grid = CellGrid(voxel_centroids(points, 0.25f), 0.5f);
  ours.neighbourhoods = find_neighbourhoods(ours.grid, kRadius);
  ours.normals = estimate_normals(ours.grid.points(), ours.neighbourhoods, kRadius);
  return ours;
}

pcl::PointCloud<pcl::PointXYZ>::Ptr to_pcl(const Points& points) {
  auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  for (const Eigen::Vector3f& p : points) cloud->push_back({p.x(), p.y(), p.z()});
  return cloud;
}

TEST(Normals, AgreeWithPcl) {
  const Ours ours = prepare();
  pcl::NormalEstimation<pcl::PointXYZ, pcl::Normal> estimation;
  estimation.setInputCloud(to_pcl(ours.grid.points()));
  estimation.setSearchMethod(pcl::make_shared<pcl::search::KdTree<pcl::PointXYZ>>());
  estimation.setRadiusSearch(kRadius);
  pcl::PointCloud<pcl::Normal> theirs;
  estimation.compute(theirs);
  ASSERT_EQ(theirs.size(), ours.grid.size());
  std::size_t close = 0;
  for (std::size_t i = 0; i < theirs.size(); ++i) {
    const Eigen::Vector3f normal = theirs[i].getNormalVector3fMap();
    close += std::fabs(normal.dot(ours.normals.normal[i])) > 0.9998f ? 1 : 0;
    EXPECT_NEAR(theirs[i].curvature, ours.normals.curvature[i], 1e-3f);
    EXPECT_LE(ours.normals.normal[i].dot(ours.grid.points()[i]), 0.0f);
  }
  // In corners two eigenvalues are nearly equal, and the normal is then anybody's.
  EXPECT_GE(close, theirs.size() * 98 / 100);
}

TEST(Fpfh, AgreesWithPclOnTheSameNormalsAndNeighbours) {
  const Ours ours = prepare();
  auto normals = pcl::make_shared<pcl::PointCloud<pcl::Normal>>();
  for (const Eigen::Vector3f& n : ours.normals.normal) normals->push_back({n.x(), n.y(), n.z()});
  pcl::FPFHEstimation<pcl::PointXYZ, pcl::Normal, pcl::FPFHSignature33> estimation;
  estimation.setInputCloud(to_pcl(ours.grid.points()));
  estimation.setInputNormals(normals);
  estimation.setSearchMethod(pcl::make_shared<pcl::search::KdTree<pcl::PointXYZ>>());
  estimation.setRadiusSearch(kRadius);
  pcl::PointCloud<pcl::FPFHSignature33> theirs;
  estimation.compute(theirs);
  const std::vector<Fpfh> features = compute_fpfh(ours.grid.points(), ours.normals, ours.neighbourhoods);
  ASSERT_EQ(theirs.size(), features.size());
  double worst = 0.0, mean = 0.0;
  for (std::size_t i = 0; i < features.size(); ++i) {
    double difference = 0.0;
    for (std::size_t b = 0; b < kFpfhBins; ++b) difference += std::fabs(features[i][b] - theirs[i].histogram[b]);
    worst = std::max(worst, difference);
    mean += difference / static_cast<double>(features.size());
  }
  // Of the 300 that a histogram sums to. Pairs on the border of two bins fall on either side by rounding.
  EXPECT_LT(mean, 0.5);
  EXPECT_LT(worst, 12.0);
}

}  // namespace
}  // namespace scanway::registration
