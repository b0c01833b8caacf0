#include "common/geometry/pose.h"

#include <cmath>

#include <gtest/gtest.h>

#include "common/random/random.h"

namespace scanway {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Vector3d random_axis(Random& random) {
  return Vector3d(random.normal(), random.normal(), random.normal()).normalized();
}

/// By Eigen, with the C library's functions: independent of ours.
Matrix3d reference(const Vector3d& axis, double angle) { return Eigen::AngleAxisd(angle, axis).toRotationMatrix(); }

TEST(Rotation, ExpAgreesWithEigenAtEverySize) {
  Random random(1);
  for (int i = 0; i < 50000; ++i) {
    const Vector3d axis = random_axis(random);
    const double angle = std::pow(10.0, -12 + 13 * random.uniform());
    ASSERT_LT((exp_so3(axis * angle) - reference(axis, angle)).norm(), 2e-15 * std::max(4.0, angle)) << angle;
  }
  EXPECT_EQ(exp_so3(Vector3d::Zero()), Matrix3d::Identity());
}

TEST(Rotation, LogUndoesExpAlsoNearZeroAndPi) {
  Random random(2);
  for (int i = 0; i < 50000; ++i) {
    const Vector3d axis = random_axis(random);
    const double off = std::pow(10.0, -14 + 14 * random.uniform());
    for (const double angle : {off, M_PI - off}) {
      const Vector3d w = log_so3(exp_so3(axis * angle));
      ASSERT_LT((w - axis * angle).norm(), 2e-14) << angle;
      ASSERT_NEAR(rotation_angle(exp_so3(axis * angle)), angle, 2e-14);
    }
  }
}

TEST(Rotation, AtPiTheAxisIsRightUpToItsSign) {
  Random random(3);
  for (int i = 0; i < 20000; ++i) {
    const Vector3d axis = i < 3 ? Vector3d(Vector3d::Unit(i)) : random_axis(random);
    const Matrix3d R = 2 * axis * axis.transpose() - Matrix3d::Identity();  // exactly half a turn
    const Vector3d w = log_so3(R);
    ASSERT_NEAR(w.norm(), M_PI, 1e-14);
    ASSERT_NEAR(std::fabs(w.dot(axis)), M_PI, 1e-14);
    ASSERT_NEAR(rotation_angle(R), M_PI, 1e-14);
  }
  EXPECT_EQ(rotation_angle(Matrix3d::Identity()), 0.0);
  EXPECT_EQ(log_so3(Matrix3d::Identity()), Vector3d(Vector3d::Zero()));
}

TEST(Rotation, HeadingIsTheAngleAboutZ) {
  for (double angle = -3.14; angle < 3.15; angle += 0.01) {
    EXPECT_NEAR(heading_of(rotation_about_z(angle)), std::remainder(angle, 2 * M_PI), 1e-15);
    EXPECT_LT((rotation_about_z(angle) - reference(Vector3d::UnitZ(), angle)).norm(), 1e-15);
  }
  EXPECT_GT(heading_of(rotation_about_z(M_PI)), 3.14);
  EXPECT_LT((rotation_about_z(M_PI / 2) * Vector3d::UnitX() - Vector3d::UnitY()).norm(), 1e-15);  // counter-clockwise
}

TEST(Rotation, NearestIsARotationAndNoneIsNearer) {
  Random random(4);
  for (int i = 0; i < 2000; ++i) {
    Matrix3d M;
    for (double& value : M.reshaped()) value = random.normal();  // half of them have a negative determinant
    const Matrix3d R = nearest_rotation(M);
    ASSERT_LT((R * R.transpose() - Matrix3d::Identity()).norm(), 1e-13);
    ASSERT_NEAR(R.determinant(), 1.0, 1e-13);
    for (int k = 0; k < 20; ++k) {
      const Matrix3d other = R * exp_so3(random_axis(random) * std::pow(10.0, -3 + 3.5 * random.uniform()));
      ASSERT_GE((M - other).norm(), (M - R).norm() - 1e-12);
    }
  }
}

TEST(Rotation, NearestMendsARoundedOne) {
  Random random(5);
  for (int i = 0; i < 1000; ++i) {
    const Matrix3d R = exp_so3(random_axis(random) * 3 * random.uniform());
    const Matrix3d rounded = (R * 1e6).array().round() / 1e6;
    ASSERT_LT(rotation_angle(nearest_rotation(rounded).transpose() * R), 2e-6);
  }
}

}  // namespace
}  // namespace scanway
