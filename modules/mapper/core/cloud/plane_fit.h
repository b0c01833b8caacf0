#pragma once

#include <array>

#include <Eigen/Core>

namespace scanway {

/// The first and second moments of some points.
class Moments {
 public:
  void add(const Eigen::Vector3d& p) {
    ++count_;
    sum_ += p;
    squares_ += p.cwiseProduct(p);
    products_ += Eigen::Vector3d(p.y() * p.z(), p.z() * p.x(), p.x() * p.y());
  }
  int count() const { return count_; }
  Eigen::Vector3d mean() const { return sum_ / count_; }
  /// Upper triangle of the covariance: xx yy zz yz zx xy.
  std::array<double, 6> covariance() const;

 private:
  int count_ = 0;
  Eigen::Vector3d sum_ = Eigen::Vector3d::Zero(), squares_ = Eigen::Vector3d::Zero(),
                  products_ = Eigen::Vector3d::Zero();
};

/// The plane of least squares through some points.
struct PlaneFit {
  Eigen::Vector3d mean, normal;  ///< The normal is of unit length, to either side.
  double across = 0.0;           ///< Variance of points about the plane: it took three of them to lay it.
  double along = 0.0;            ///< The smaller one in the plane.
};

/// Of three points or more. Square roots and Newton's steps only: the same bits on every CPU.
PlaneFit fit_plane(const Moments& moments);

}  // namespace scanway
