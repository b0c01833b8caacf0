// The paper's map of a real scan: its floor and its obstacles against those by PCL's RANSAC.
#include <cmath>
#include <filesystem>
#include <set>
#include <string>

#include <gtest/gtest.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/segmentation/sac_segmentation.h>

#include "common/cloud/read_cloud.h"
#include "modules/mapper/core/costmap/paper_projection.h"

namespace scanway {
namespace {

/// The largest near-level plane below the sensor, as n . p + d = 0 with n up.
Eigen::Vector4d floor_by_pcl(const PointCloud& scan) {
  const pcl::PointCloud<pcl::PointXYZ>::Ptr below(new pcl::PointCloud<pcl::PointXYZ>);
  for (const Eigen::Vector3f& p : scan.points) {
    if (p.z() < 0.0f) below->push_back({p.x(), p.y(), p.z()});
  }
  pcl::SACSegmentation<pcl::PointXYZ> ransac;
  ransac.setModelType(pcl::SACMODEL_PERPENDICULAR_PLANE);
  ransac.setAxis(Eigen::Vector3f::UnitZ());
  ransac.setEpsAngle(0.2618);
  ransac.setMethodType(pcl::SAC_RANSAC);
  ransac.setDistanceThreshold(0.03);
  ransac.setMaxIterations(1000);
  ransac.setOptimizeCoefficients(true);
  ransac.setInputCloud(below);
  pcl::PointIndices inliers;
  pcl::ModelCoefficients plane;
  ransac.segment(inliers, plane);
  Eigen::Vector4d floor(plane.values[0], plane.values[1], plane.values[2], plane.values[3]);
  return floor.z() < 0.0 ? Eigen::Vector4d(-floor) : floor;
}

/// The paper's obstacles: what is neither from 0 to 2 cm over the floor, widened by 1 cm, nor higher than 1.5 m.
std::set<Cell> obstacles_over(const Eigen::Vector4d& floor, const PointCloud& scan, double reach) {
  std::set<Cell> cells;
  for (const Eigen::Vector3f& point : scan.points) {
    const Eigen::Vector3d p = point.cast<double>();
    const double above = floor.head<3>().dot(p) + floor[3];
    if (p.head<2>().norm() > reach || (above >= -0.01 && above <= 0.03) || above > 1.5) continue;
    cells.insert(
        {static_cast<std::int32_t>(std::floor(p.x() / 0.01)), static_cast<std::int32_t>(std::floor(p.y() / 0.01))});
  }
  return cells;
}

TEST(PaperProjection, HasTheFloorAndTheObstaclesThatPclsRansacGives) {
  const std::string folder = SCANWAY_SHARED_DIR "/data/hall_scans_a";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no " << folder;
  for (const std::string name : {"scan000", "scan003"}) {
    const PointCloud scan = read_cloud(folder + "/" + name + ".pcd");
    const Eigen::Vector4d theirs = floor_by_pcl(scan);
    const auto ours = find_ground_plane({scan.points, {}, Eigen::Vector3d::Zero()}, {});
    ASSERT_TRUE(ours.has_value());
    for (const Eigen::Vector2d& at : {Eigen::Vector2d(0, 0), Eigen::Vector2d(5, 5), Eigen::Vector2d(-5, 5)}) {
      EXPECT_NEAR(ours->height_at(at.x(), at.y()), -(theirs.head<2>().dot(at) + theirs[3]) / theirs[2], 0.01) << name;
    }
    CostMap map;
    project_as_paper(map, scan, *ours, Robot{}, {Eigen::Vector3d::Zero()}, 15.0);
    const std::set<Cell> expected = obstacles_over(theirs, scan, 15.0);
    std::size_t occupied = 0, both = 0;
    for (const auto& [index, tile] : map.tiles) {
      for (std::int32_t i = 0; i < static_cast<std::int32_t>(CostTile::kCells); ++i) {
        const Cell cell{index.x * CostTile::kSide + i % CostTile::kSide,
                        index.y * CostTile::kSide + i / CostTile::kSide};
        if (map.state(cell) != CellState::occupied) continue;
        ++occupied;
        both += expected.count(cell);
      }
    }
    EXPECT_GT(expected.size(), 3000u);
    // Points at the band's edge fall to one side or the other with a millimetre of the floor's height.
    EXPECT_GE(both, occupied * 96 / 100) << name;
    EXPECT_GE(both, expected.size() * 96 / 100) << name;
  }
}

}  // namespace
}  // namespace scanway
