#include "common/geometry/pose.h"

#include <cmath>

#include <Eigen/SVD>

#include "common/math/repeatable.h"

namespace scanway {
namespace {

Eigen::Matrix3d cross_matrix(const Eigen::Vector3d& w) {
  Eigen::Matrix3d W;
  W << 0, -w.z(), w.y(), w.z(), 0, -w.x(), -w.y(), w.x(), 0;
  return W;
}

/// Twice the sine of the rotation's angle, times its axis.
Eigen::Vector3d skew_part(const Eigen::Matrix3d& R) {
  return {R(2, 1) - R(1, 2), R(0, 2) - R(2, 0), R(1, 0) - R(0, 1)};
}

}  // namespace

double rotation_angle(const Eigen::Matrix3d& R) { return repeatable::atan2(skew_part(R).norm(), R.trace() - 1.0); }

Eigen::Matrix3d rotation_about_z(double angle) {
  const double c = repeatable::cos(angle), s = repeatable::sin(angle);
  Eigen::Matrix3d R;
  R << c, -s, 0, s, c, 0, 0, 0, 1;
  return R;
}

double heading_of(const Eigen::Matrix3d& R) { return repeatable::atan2(R(1, 0), R(0, 0)); }

Eigen::Matrix3d exp_so3(const Eigen::Vector3d& w) {
  const double angle = w.norm();
  const Eigen::Matrix3d W = cross_matrix(w);
  // Rodrigues' formula; its Taylor terms below 1e-4 rad, where the quotients lose digits.
  const double a = angle < 1e-4 ? 1.0 - angle * angle / 6.0 : repeatable::sin(angle) / angle;
  const double b = angle < 1e-4 ? 0.5 - angle * angle / 24.0 : (1.0 - repeatable::cos(angle)) / (angle * angle);
  return Eigen::Matrix3d::Identity() + a * W + b * W * W;
}

Eigen::Vector3d log_so3(const Eigen::Matrix3d& R) {
  const Eigen::Quaterniond q(R);
  const double sine = q.vec().norm();
  if (sine < 1e-12) return 2.0 * q.vec() * (q.w() < 0 ? -1.0 : 1.0);
  const double half = q.w() < 0 ? -repeatable::atan2(sine, -q.w()) : repeatable::atan2(sine, q.w());
  return q.vec() * (2.0 * half / sine);
}

Eigen::Matrix3d nearest_rotation(const Eigen::Matrix3d& M) {
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(M, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Matrix3d U = svd.matrixU();
  // A reflection may lie nearer; among the rotations the nearest gives up the weakest direction.
  if ((U * svd.matrixV().transpose()).determinant() < 0) U.col(2) = -U.col(2);
  return U * svd.matrixV().transpose();
}

}  // namespace scanway
