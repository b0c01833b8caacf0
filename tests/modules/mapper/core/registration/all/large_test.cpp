#include <gtest/gtest.h>

#include "modules/mapper/core/registration/registration.h"
#include "tests/modules/mapper/core/registration/random_points.h"

namespace scanway {
namespace {

/// `count` points of a room with 3 mm of noise, seen from where `T` puts it.
PointCloud large_room(std::size_t count, const Pose& T, Random& random) {
  const registration::Points room = registration::room(0.06f);
  PointCloud cloud;
  cloud.points.reserve(count);
  const Eigen::Isometry3f to_scan = T.inverse().cast<float>();
  while (cloud.size() < count) {
    const Eigen::Vector3f noise = registration::random_point(random, 0.005f);
    cloud.points.push_back(to_scan * Eigen::Vector3f(room[cloud.size() % room.size()] + noise));
  }
  return cloud;
}

TEST(LargeScans, TwentyMillionPointsAreRegistered) {
  Random random(5);
  Pose T = Pose::Identity();
  T.linear() = rotation_about_z(0.3);
  T.translation() = Eigen::Vector3d(0.6, -0.4, 0.0);
  const auto prepare = [](const PointCloud& cloud) { return PreparedScan::make(cloud, Eigen::Vector3d::Zero(), {}); };
  const PreparedScan source = prepare(large_room(20'000'000, T, random));
  const PreparedScan target = prepare(large_room(20'000'000, Pose::Identity(), random));
  OrientationPrior prior;
  prior.R_target_source = rotation_about_z(0.25);
  const RegistrationResult result = register_scans(source, target, prior, {});
  EXPECT_EQ(result.verdict, Verdict::accepted) << result.reason;
  EXPECT_LT((result.T_target_source.translation() - T.translation()).norm(), 0.005);
}

}  // namespace
}  // namespace scanway
