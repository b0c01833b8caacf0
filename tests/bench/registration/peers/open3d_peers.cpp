#include "tests/bench/registration/peers/open3d_peers.h"

#include <omp.h>
#include <open3d/geometry/KDTreeSearchParam.h>
#include <open3d/geometry/PointCloud.h>
#include <open3d/pipelines/registration/CorrespondenceChecker.h>
#include <open3d/pipelines/registration/FastGlobalRegistration.h>
#include <open3d/pipelines/registration/Feature.h>
#include <open3d/pipelines/registration/Registration.h>
#include <open3d/pipelines/registration/TransformationEstimation.h>

#include "tests/bench/registration/cpu_clock.h"

namespace scanway::bench {
namespace {

namespace o3d = open3d::pipelines::registration;
using Cloud = open3d::geometry::PointCloud;

constexpr int kNormalNeighbours = 30, kFeatureNeighbours = 100;  // at most, as in Open3D's examples
constexpr int kIterations = 50;                                  // of the ICP

Cloud thinned(const PointCloud& cloud, double voxel_m) {
  Cloud all;
  for (const Eigen::Vector3f& p : cloud.points) all.points_.push_back(p.cast<double>());
  return *all.VoxelDownSample(voxel_m);
}

struct Described {
  Cloud cloud;
  std::shared_ptr<o3d::Feature> features;
};

Described describe(const PointCloud& cloud) {
  Described described{thinned(cloud, kCoarseVoxel), nullptr};
  described.cloud.EstimateNormals(open3d::geometry::KDTreeSearchParamHybrid(kNormalRadius, kNormalNeighbours));
  described.cloud.OrientNormalsTowardsCameraLocation();
  const open3d::geometry::KDTreeSearchParamHybrid near(kFeatureRadius, kFeatureNeighbours);
  described.features = o3d::ComputeFPFHFeature(described.cloud, near);
  return described;
}

PeerAnswer answer(const char* name, const Eigen::Matrix4d& T, double begin) {
  PeerAnswer answer{name, Pose::Identity(), cpu_s() - begin};
  answer.T_target_source.matrix() = T;
  answer.T_target_source.linear() = nearest_rotation(answer.T_target_source.linear());
  return answer;
}

}  // namespace

PeerAnswer open3d_fgr(const PointCloud& source, const PointCloud& target) {
  omp_set_num_threads(1);
  const double begin = cpu_s();
  const Described from = describe(source), to = describe(target);
  o3d::FastGlobalRegistrationOption option;
  option.use_absolute_scale_ = true;
  option.maximum_correspondence_distance_ = kCorrespondence;
  const auto result =
      o3d::FastGlobalRegistrationBasedOnFeatureMatching(from.cloud, to.cloud, *from.features, *to.features, option);
  return answer("Open3D FPFH + FGR", result.transformation_, begin);
}

PeerAnswer open3d_ransac(const PointCloud& source, const PointCloud& target) {
  omp_set_num_threads(1);
  const double begin = cpu_s();
  const Described from = describe(source), to = describe(target);
  const o3d::CorrespondenceCheckerBasedOnEdgeLength lengths(0.9);
  const o3d::CorrespondenceCheckerBasedOnDistance distances(kCorrespondence);
  const auto result = o3d::RegistrationRANSACBasedOnFeatureMatching(
      from.cloud, to.cloud, *from.features, *to.features, true, kCorrespondence,
      o3d::TransformationEstimationPointToPoint(false), 3, {lengths, distances},
      o3d::RANSACConvergenceCriteria(100000, 0.999));
  return answer("Open3D FPFH + RANSAC", result.transformation_, begin);
}

PeerAnswer open3d_icp_planes(const PointCloud& source, const PointCloud& target, const Pose& start) {
  omp_set_num_threads(1);
  const double begin = cpu_s();
  Cloud from = thinned(source, kFineVoxel), to = thinned(target, kFineVoxel);
  to.EstimateNormals(open3d::geometry::KDTreeSearchParamHybrid(3.5 * kFineVoxel, kNormalNeighbours));
  const auto result =
      o3d::RegistrationICP(from, to, kFineCorrespondence, start.matrix(), o3d::TransformationEstimationPointToPlane(),
                           o3d::ICPConvergenceCriteria(1e-9, 1e-9, kIterations));
  return answer("Open3D ICP, point to plane", result.transformation_, begin);
}

}  // namespace scanway::bench
