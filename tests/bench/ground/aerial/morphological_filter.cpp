#include "tests/bench/ground/aerial/morphological_filter.h"

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/segmentation/progressive_morphological_filter.h>

namespace scanway::bench {

std::vector<bool> morphological_filter(const Sample& sample) {
  const pcl::PointCloud<pcl::PointXYZ>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZ>);
  for (const Eigen::Vector3d& p : sample.points) {
    const Eigen::Vector3f q = p.cast<float>();
    cloud->push_back({q.x(), q.y(), q.z()});
  }
  pcl::ProgressiveMorphologicalFilter<pcl::PointXYZ> filter;
  filter.setInputCloud(cloud);
  filter.setMaxWindowSize(20);
  filter.setSlope(1.0f);
  filter.setInitialDistance(0.5f);
  filter.setMaxDistance(3.0f);
  pcl::Indices indices;
  filter.extract(indices);
  std::vector<bool> ground(sample.points.size(), false);
  for (const auto i : indices) ground[static_cast<std::size_t>(i)] = true;
  return ground;
}

}  // namespace scanway::bench
