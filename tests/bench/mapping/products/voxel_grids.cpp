#include "tests/bench/mapping/products/voxel_grids.h"

#include <pcl/filters/voxel_grid.h>
#include <pcl/point_types.h>

#include <cstdio>

#include "common/random/random.h"
#include "modules/mapper/core/cloud/voxel_cloud.h"
#include "tests/bench/mapping/products/cpu_time.h"
#include "tests/bench/mapping/yard/yard.h"

namespace scanway::bench {
namespace {

void row(const char* who, double voxel_m, double seconds, std::size_t points) {
  std::printf("| %s | %g | %.3f | %zu |\n", who, voxel_m, seconds, points);
}

void ours(const char* who, const MapPoints& sweep, double voxel_m) {
  std::size_t points = 0;
  const double seconds = median_cpu_s(5, [&] {
    VoxelCloud cloud(voxel_m);
    cloud.put(0, sweep);
    points = cloud.centroids().size();
  });
  row(who, voxel_m, seconds, points);
}

void theirs(const MapPoints& sweep, float voxel_m) {
  const auto cloud = std::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  for (const Eigen::Vector3f& p : sweep.points) cloud->emplace_back(p.x(), p.y(), p.z());
  std::size_t points = 0;
  const double seconds = median_cpu_s(5, [&] {
    pcl::VoxelGrid<pcl::PointXYZ> grid;
    grid.setInputCloud(cloud);
    grid.setLeafSize(voxel_m, voxel_m, voxel_m);
    pcl::PointCloud<pcl::PointXYZ> thinned;
    grid.filter(thinned);
    points = thinned.size();
  });
  row("PCL", voxel_m, seconds, points);
}

}  // namespace

void compare_voxel_grids() {
  MapPoints sweep = yard_sweep(0, kFullRound, kFullUp);
  std::puts("| voxel grid of 3.4 M points | voxel, m | CPU s | voxels |\n|---|---|---|---|");
  theirs(sweep, 0.1f);
  ours("Scanway", sweep, 0.1);
  ours("Scanway", sweep, 0.01);
  Random random(3);
  for (std::size_t i = 0; i < sweep.points.size(); ++i)
    sweep.intensity.push_back(static_cast<float>(random.below(256)));
  ours("Scanway, with intensities", sweep, 0.01);
}

}  // namespace scanway::bench
