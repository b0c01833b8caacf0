#include "common/messages/rigid.h"

#include <cmath>

#include "common/messages/bad_message.h"

namespace scanway {

namespace {

constexpr double kUnitTolerance = 1e-3;

}  // namespace

void put_quaternion(const Eigen::Quaterniond& R, double (&wxyz)[4]) {
  wxyz[0] = R.w();
  wxyz[1] = R.x();
  wxyz[2] = R.y();
  wxyz[3] = R.z();
}

Eigen::Quaterniond get_quaternion(const double (&wxyz)[4]) {
  const Eigen::Quaterniond R(wxyz[0], wxyz[1], wxyz[2], wxyz[3]);
  if (!(std::abs(R.norm() - 1.0) <= kUnitTolerance)) throw BadMessage("a quaternion that is no rotation");
  return R.normalized();
}

void put_rows(const Pose& X, double (&rows)[16]) {
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) rows[4 * row + column] = X.matrix()(row, column);
  }
}

Pose get_rows(const double (&rows)[12]) {
  Pose X = Pose::Identity();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) X.matrix()(row, column) = rows[4 * row + column];
  }
  if (!X.matrix().allFinite()) throw BadMessage("a pose with numbers that are not finite");
  return X;
}

Pose get_rows(const double (&rows)[16]) {
  if (rows[12] != 0 || rows[13] != 0 || rows[14] != 0 || rows[15] != 1) throw BadMessage("a pose that is not rigid");
  double upper[12];
  for (int i = 0; i < 12; ++i) upper[i] = rows[i];
  return get_rows(upper);
}

}  // namespace scanway
