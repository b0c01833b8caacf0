#include "tests/bench/registration/peers/pcl_peers.h"

#include <pcl/features/fpfh.h>
#include <pcl/features/normal_3d.h>
#include <pcl/filters/voxel_grid.h>
#include <pcl/point_types.h>
#include <pcl/registration/ia_ransac.h>
#include <pcl/registration/icp.h>
#include <pcl/registration/sample_consensus_prerejective.h>

#include "tests/bench/registration/cpu_clock.h"

namespace scanway::bench {
namespace {

using Point = pcl::PointXYZ;
using PointNormal = pcl::PointNormal;
using Cloud = pcl::PointCloud<PointNormal>;
using Features = pcl::PointCloud<pcl::FPFHSignature33>;

constexpr double kNormalRadiusFine = 0.35;  // of the ICP's normals: 3.5 voxels
constexpr int kIterations = 50;             // of the ICP

Cloud::Ptr thinned(const PointCloud& cloud, float voxel_m) {
  const pcl::PointCloud<Point>::Ptr all(new pcl::PointCloud<Point>);
  for (const Eigen::Vector3f& p : cloud.points) all->emplace_back(p.x(), p.y(), p.z());
  pcl::VoxelGrid<Point> grid;
  grid.setInputCloud(all);
  grid.setLeafSize(voxel_m, voxel_m, voxel_m);
  pcl::PointCloud<Point> thin;
  grid.filter(thin);
  const Cloud::Ptr result(new Cloud);
  pcl::copyPointCloud(thin, *result);
  return result;
}

void add_normals(const Cloud::Ptr& cloud, double radius_m) {
  pcl::NormalEstimation<PointNormal, PointNormal> normals;
  normals.setInputCloud(cloud);
  normals.setRadiusSearch(radius_m);
  normals.compute(*cloud);
  pcl::PointCloud<PointNormal> kept;  // SAC-IA and ICP do not take NaN
  for (const PointNormal& p : *cloud) {
    if (std::isfinite(p.normal_x)) kept.push_back(p);
  }
  *cloud = kept;
}

struct Described {
  Cloud::Ptr cloud;
  Features::Ptr features{new Features};
};

Described describe(const PointCloud& cloud) {
  Described described{thinned(cloud, kCoarseVoxel)};
  add_normals(described.cloud, kNormalRadius);
  pcl::FPFHEstimation<PointNormal, PointNormal, pcl::FPFHSignature33> fpfh;
  fpfh.setInputCloud(described.cloud);
  fpfh.setInputNormals(described.cloud);
  fpfh.setRadiusSearch(kFeatureRadius);
  fpfh.compute(*described.features);
  return described;
}

Pose pose_of(const Eigen::Matrix4f& T) {
  Pose pose;
  pose.matrix() = T.cast<double>();
  pose.linear() = nearest_rotation(pose.linear());
  return pose;
}

template <class Method>
PeerAnswer align_features(const char* name, Method& method, const PointCloud& source, const PointCloud& target) {
  const double begin = cpu_s();
  const Described from = describe(source), to = describe(target);
  method.setInputSource(from.cloud);
  method.setSourceFeatures(from.features);
  method.setInputTarget(to.cloud);
  method.setTargetFeatures(to.features);
  Cloud moved;
  method.align(moved);
  return {name, pose_of(method.getFinalTransformation()), cpu_s() - begin};
}

template <class Icp>
PeerAnswer align_finely(const char* name, Icp& icp, const PointCloud& source, const PointCloud& target,
                        const Pose& start, bool normals) {
  const double begin = cpu_s();
  const Cloud::Ptr from = thinned(source, kFineVoxel), to = thinned(target, kFineVoxel);
  if (normals) add_normals(from, kNormalRadiusFine), add_normals(to, kNormalRadiusFine);
  icp.setInputSource(from);
  icp.setInputTarget(to);
  icp.setMaxCorrespondenceDistance(kFineCorrespondence);
  icp.setMaximumIterations(kIterations);
  icp.setTransformationEpsilon(1e-10);
  Cloud moved;
  icp.align(moved, start.matrix().cast<float>());
  return {name, pose_of(icp.getFinalTransformation()), cpu_s() - begin};
}

}  // namespace

PeerAnswer pcl_sac_ia(const PointCloud& source, const PointCloud& target) {
  pcl::SampleConsensusInitialAlignment<PointNormal, PointNormal, pcl::FPFHSignature33> method;
  method.setMinSampleDistance(kFeatureRadius);
  method.setMaxCorrespondenceDistance(kCorrespondence);
  return align_features("PCL FPFH + SAC-IA", method, source, target);
}

PeerAnswer pcl_prerejective(const PointCloud& source, const PointCloud& target) {
  pcl::SampleConsensusPrerejective<PointNormal, PointNormal, pcl::FPFHSignature33> method;
  method.setMaximumIterations(50000);
  method.setNumberOfSamples(3);
  method.setCorrespondenceRandomness(5);
  method.setSimilarityThreshold(0.9f);
  method.setMaxCorrespondenceDistance(kCorrespondence);
  method.setInlierFraction(0.25f);
  return align_features("PCL FPFH + Prerejective", method, source, target);
}

PeerAnswer pcl_icp_points(const PointCloud& source, const PointCloud& target, const Pose& start) {
  pcl::IterativeClosestPoint<PointNormal, PointNormal> icp;
  return align_finely("PCL ICP, point to point", icp, source, target, start, false);
}

PeerAnswer pcl_icp_planes(const PointCloud& source, const PointCloud& target, const Pose& start) {
  pcl::IterativeClosestPointWithNormals<PointNormal, PointNormal> icp;
  return align_finely("PCL ICP, point to plane", icp, source, target, start, true);
}

}  // namespace scanway::bench
