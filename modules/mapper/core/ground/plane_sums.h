#pragma once

#include <Eigen/Core>

namespace scanway {

/// u = c + a x + b y, metres.
struct LocalPlane {
  double a = 0.0, b = 0.0, c = 0.0;
  double at(double x, double y) const { return c + a * x + b * y; }
};

/// The plane through points (x, y, u), by least squares.
class PlaneSums {
 public:
  void add(const Eigen::Vector3d& p) {
    n_ += 1.0, x_ += p.x(), y_ += p.y(), u_ += p.z();
    xx_ += p.x() * p.x(), xy_ += p.x() * p.y(), yy_ += p.y() * p.y(), xu_ += p.x() * p.z(), yu_ += p.y() * p.z();
  }
  LocalPlane plane() const {
    const double sxx = xx_ - x_ * x_ / n_ + kShrinkage, syy = yy_ - y_ * y_ / n_ + kShrinkage, sxy = xy_ - x_ * y_ / n_;
    const double sxu = xu_ - x_ * u_ / n_, syu = yu_ - y_ * u_ / n_;
    const double determinant = sxx * syy - sxy * sxy;
    const double a = (sxu * syy - syu * sxy) / determinant, b = (syu * sxx - sxu * sxy) / determinant;
    return {a, b, (u_ - a * x_ - b * y_) / n_};
  }

 private:
  static constexpr double kShrinkage = 0.01;  ///< m^2: draws the slope towards 0 where points are few.

  double n_ = 0.0, x_ = 0.0, y_ = 0.0, u_ = 0.0, xx_ = 0.0, xy_ = 0.0, yy_ = 0.0, xu_ = 0.0, yu_ = 0.0;
};

}  // namespace scanway
