#include "modules/mapper/core/cloud/plane_fit.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace scanway {
namespace {

constexpr int kMostSteps = 12;

/// The coefficients of a symmetric matrix's characteristic polynomial v^3 - trace v^2 + minors v - determinant.
struct Characteristic {
  double trace, minors, determinant;

  double value(double v) const { return ((v - trace) * v + minors) * v - determinant; }
  double slope(double v) const { return (3.0 * v - 2.0 * trace) * v + minors; }
};

Characteristic characteristic_of(const std::array<double, 6>& c) {
  const auto [xx, yy, zz, yz, zx, xy] = c;
  const double yz_minor = yy * zz - yz * yz;
  return {xx + yy + zz, yz_minor + (zz * xx - zx * zx) + (xx * yy - xy * xy),
          xx * yz_minor - xy * (xy * zz - yz * zx) + zx * (xy * yz - yy * zx)};
}

/// From 0 Newton's steps rise to the least root without passing it, for up to there the polynomial is concave.
double least_root(const Characteristic& polynomial) {
  double v = 0.0;
  for (int step = 0; step < kMostSteps; ++step) {
    const double slope = polynomial.slope(v), value = polynomial.value(v);
    if (!(slope > 0.0) || !(value < 0.0)) break;
    const double next = v - value / slope;
    if (!(next > v)) break;
    v = next;
  }
  return v;
}

/// A vector that is orthogonal to the rows of the covariance less `value` on its diagonal: the longest of their cross
/// products is the best of all.
Eigen::Vector3d eigenvector(const std::array<double, 6>& c, double value) {
  const auto [xx, yy, zz, yz, zx, xy] = c;
  const Eigen::Vector3d rows[3] = {{xx - value, xy, zx}, {xy, yy - value, yz}, {zx, yz, zz - value}};
  Eigen::Vector3d best = rows[0].cross(rows[1]);
  for (const Eigen::Vector3d& other : {rows[1].cross(rows[2]).eval(), rows[2].cross(rows[0]).eval()}) {
    if (other.squaredNorm() > best.squaredNorm()) best = other;
  }
  const double length = best.norm();
  return length > 0.0 ? Eigen::Vector3d(best / length) : Eigen::Vector3d::UnitZ();
}

}  // namespace

std::array<double, 6> Moments::covariance() const {
  const Eigen::Vector3d m = mean(), square = squares_ / count_, product = products_ / count_;
  return {square.x() - m.x() * m.x(),  square.y() - m.y() * m.y(),  square.z() - m.z() * m.z(),
          product.x() - m.y() * m.z(), product.y() - m.z() * m.x(), product.z() - m.x() * m.y()};
}

PlaneFit fit_plane(const Moments& moments) {
  const std::array<double, 6> covariance = moments.covariance();
  const Characteristic polynomial = characteristic_of(covariance);
  PlaneFit fit;
  fit.mean = moments.mean();
  const double least = fit.across = least_root(polynomial);
  fit.normal = eigenvector(covariance, least);
  if (moments.count() > 3) fit.across *= moments.count() / (moments.count() - 3.0);
  // The two other roots by their sum and product.
  const double sum = polynomial.trace - least, product = polynomial.minors - least * sum;
  fit.along = 0.5 * (sum - std::sqrt(std::max(0.0, sum * sum - 4.0 * product)));
  return fit;
}

}  // namespace scanway
