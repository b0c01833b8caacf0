#include "modules/mapper/core/registration/rigid.h"

#include <gtest/gtest.h>

#include "modules/mapper/core/registration/eigen3.h"
#include "tests/modules/mapper/core/registration/random_points.h"

namespace scanway::registration {
namespace {

Pose random_pose(Random& random) {
  Pose T = Pose::Identity();
  T.linear() = exp_so3(random_point(random, 2.0f).cast<double>());
  T.translation() = random_point(random, 20.0f).cast<double>();
  return T;
}

TEST(Rigid, RecoversAnyTransformAlsoFromPointsOnOnePlane) {
  Random random(1);
  for (int k = 0; k < 100; ++k) {
    const Pose T = random_pose(random);
    std::vector<PointPair> pairs;
    for (int i = 0; i < 3 + k % 20; ++i) {
      Eigen::Vector3d p = random_point(random, 10.0f).cast<double>();
      if (k % 2 == 0) p.z() = 0.0;
      pairs.push_back({p, T * p, 0.1 + random.uniform()});
    }
    const Pose found = rigid_from_pairs(pairs);
    EXPECT_LT((found.matrix() - T.matrix()).norm(), 1e-6);
    EXPECT_NEAR(found.linear().determinant(), 1.0, 1e-9);
  }
}

TEST(Rigid, IsARotationForDegenerateAndMirroredPairs) {
  Random random(2);
  std::vector<PointPair> mirrored, line;
  for (int i = 0; i < 20; ++i) {
    const Eigen::Vector3d p = random_point(random, 5.0f).cast<double>();
    mirrored.push_back({p, Eigen::Vector3d(-p.x(), p.y(), p.z()), 1.0});
    line.push_back({Eigen::Vector3d(i, 0, 0), Eigen::Vector3d(0, i, 0), 1.0});
  }
  for (const auto& pairs : {mirrored, line, std::vector<PointPair>{}, std::vector<PointPair>{line[1]}}) {
    const Eigen::Matrix3d R = rigid_from_pairs(pairs).linear();
    EXPECT_NEAR(R.determinant(), 1.0, 1e-9);
    EXPECT_LT((R * R.transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-9);
  }
}

TEST(Eigen3, DecomposesSymmetricMatricesOfEveryRank) {
  Random random(3);
  for (int k = 0; k < 300; ++k) {
    Eigen::Matrix3d A = Eigen::Matrix3d::Zero();
    for (int i = 0; i < k % 4; ++i) {
      const Eigen::Vector3d v = random_point(random, 3.0f).cast<double>();
      A += v * v.transpose();
    }
    const Eigen3 eigen = symmetric_eigen(A);
    const Eigen::Matrix3d back = eigen.vectors * eigen.values.asDiagonal() * eigen.vectors.transpose();
    EXPECT_LT((back - A).norm(), 1e-10 * (1.0 + A.norm()));
    EXPECT_LE(eigen.values[0], eigen.values[1]);
    EXPECT_LE(eigen.values[1], eigen.values[2]);
  }
}

}  // namespace
}  // namespace scanway::registration
