#include "modules/mapper/core/registration/eigen3.h"

#include <cmath>
#include <utility>

namespace scanway::registration {
namespace {

constexpr int kMaxSweeps = 12;  // converges quadratically: 5 to 7 in practice

/// The rotation in the plane (p, q) that makes A(p, q) zero; Golub and Van Loan, algorithm 8.4.1.
void rotate(Eigen::Matrix3d& A, Eigen::Matrix3d& V, int p, int q) {
  if (A(p, q) == 0.0) return;
  const double tau = (A(q, q) - A(p, p)) / (2.0 * A(p, q));
  const double t = (tau >= 0 ? 1.0 : -1.0) / (std::fabs(tau) + std::sqrt(1.0 + tau * tau));
  const double c = 1.0 / std::sqrt(1.0 + t * t), s = t * c;
  const int r = 3 - p - q;
  A(p, p) -= t * A(p, q);
  A(q, q) += t * A(p, q);
  A(p, q) = A(q, p) = 0.0;
  const double rp = A(r, p), rq = A(r, q);
  A(r, p) = A(p, r) = c * rp - s * rq;
  A(r, q) = A(q, r) = s * rp + c * rq;
  for (int k = 0; k < 3; ++k) {
    const double vp = V(k, p), vq = V(k, q);
    V(k, p) = c * vp - s * vq;
    V(k, q) = s * vp + c * vq;
  }
}

}  // namespace

Eigen3 symmetric_eigen(const Eigen::Matrix3d& matrix) {
  Eigen::Matrix3d A = matrix, V = Eigen::Matrix3d::Identity();
  for (int sweep = 0; sweep < kMaxSweeps; ++sweep) {
    const double off = A(0, 1) * A(0, 1) + A(0, 2) * A(0, 2) + A(1, 2) * A(1, 2);
    const double on = A(0, 0) * A(0, 0) + A(1, 1) * A(1, 1) + A(2, 2) * A(2, 2);
    if (!(off > 1e-26 * on)) break;
    rotate(A, V, 0, 1);
    rotate(A, V, 0, 2);
    rotate(A, V, 1, 2);
  }
  int order[3] = {0, 1, 2};
  if (A(order[1], order[1]) < A(order[0], order[0])) std::swap(order[0], order[1]);
  if (A(order[2], order[2]) < A(order[1], order[1])) std::swap(order[1], order[2]);
  if (A(order[1], order[1]) < A(order[0], order[0])) std::swap(order[0], order[1]);
  Eigen3 result;
  for (int k = 0; k < 3; ++k) {
    result.values[k] = A(order[k], order[k]);
    result.vectors.col(k) = V.col(order[k]);
  }
  return result;
}

}  // namespace scanway::registration
