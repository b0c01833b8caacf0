#include "modules/mapper/core/registration/rigid.h"

#include <Eigen/SVD>

namespace scanway::registration {

Pose rigid_from_pairs(std::span<const PointPair> pairs) {
  Eigen::Vector3d source_mean = Eigen::Vector3d::Zero(), target_mean = Eigen::Vector3d::Zero();
  double total = 0.0;
  for (const PointPair& pair : pairs) {
    source_mean += pair.weight * pair.source;
    target_mean += pair.weight * pair.target;
    total += pair.weight;
  }
  if (!(total > 0.0)) return Pose::Identity();
  source_mean /= total;
  target_mean /= total;
  Eigen::Matrix3d H = Eigen::Matrix3d::Zero();
  for (const PointPair& pair : pairs) {
    H += pair.weight * (pair.target - target_mean) * (pair.source - source_mean).transpose();
  }
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(H, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Vector3d sign = Eigen::Vector3d::Ones();
  if ((svd.matrixU() * svd.matrixV().transpose()).determinant() < 0.0) sign.z() = -1.0;  // never a mirror image
  Pose T = Pose::Identity();
  T.linear() = svd.matrixU() * sign.asDiagonal() * svd.matrixV().transpose();
  T.translation() = target_mean - T.linear() * source_mean;
  return T;
}

}  // namespace scanway::registration
