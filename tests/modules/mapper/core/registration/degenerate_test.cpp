#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "modules/mapper/core/registration/registration.h"
#include "tests/modules/mapper/core/registration/random_points.h"

namespace scanway {
namespace {

using registration::random_point;

PointCloud cloud_of(registration::Points points) { return {std::move(points), {}, {}}; }

RegistrationResult register_clouds(const PointCloud& source, const PointCloud& target,
                                   const Eigen::Vector3d& origin = Eigen::Vector3d::Zero(),
                                   const std::optional<OrientationPrior>& prior = OrientationPrior{}) {
  const RegistrationConfig config;
  return register_scans(PreparedScan::make(source, origin, config), PreparedScan::make(target, origin, config), prior,
                        config);
}

/// What sensors and files can deliver that cannot be registered.
std::vector<PointCloud> hopeless_clouds() {
  Random random(9);
  PointCloud plane, line, duplicates, ten, not_finite, far, ball, tiny;
  for (int i = 0; i < 5000; ++i) {
    const Eigen::Vector3f p = random_point(random, 8.0f);
    plane.points.push_back({p.x(), p.y(), -1.0f});
    line.points.push_back({p.x(), 1.0f, 0.5f});
    duplicates.points.push_back({1, 2, 3});
    not_finite.points.push_back({std::nanf(""), p.y(), std::numeric_limits<float>::infinity()});
    far.points.push_back(p + Eigen::Vector3f(1000, 0, 0));
    ball.points.push_back(p);
    tiny.points.push_back(p * 0.01f);
  }
  ten.points.assign(ball.points.begin(), ball.points.begin() + 10);
  PointCloud one;
  one.points.push_back({1, 2, 3});
  return {{}, one, ten, plane, line, duplicates, not_finite, far, ball, tiny};
}

TEST(Registration, RefusesWhatCannotBeRegisteredAndSaysWhy) {
  const PointCloud room = cloud_of(registration::room(0.08f));
  for (const PointCloud& cloud : hopeless_clouds()) {
    for (const RegistrationResult& result :
         {register_clouds(cloud, room), register_clouds(room, cloud),
          register_clouds(cloud, room, Eigen::Vector3d::Zero(), std::nullopt), register_clouds(cloud, cloud)}) {
      EXPECT_EQ(result.verdict, Verdict::refused);
      EXPECT_FALSE(result.reason.empty());
      EXPECT_LE(result.probability, 0.5) << result.reason;
      EXPECT_TRUE(result.T_target_source.matrix().allFinite());
    }
  }
}

TEST(Registration, FindsARoomMovedAndTurnedAlsoOneKilometreFromTheOrigin) {
  const registration::Points room = registration::room(0.06f);
  Random random(11);
  for (const double offset : {0.0, 1000.0}) {
    // The target's sensor stands at (offset, 0, 0) of its frame, and so does the source's in its own.
    const Eigen::Vector3d origin(offset, 0, 0);
    Pose T_sensors = Pose::Identity();
    T_sensors.linear() = rotation_about_z(0.5);
    T_sensors.translation() = Eigen::Vector3d(0.8, -0.5, 0.02);
    PointCloud target, source;
    for (const Eigen::Vector3f& p : room) {
      const Eigen::Vector3d noise = 0.003 * Eigen::Vector3d(random.normal(), random.normal(), random.normal());
      target.points.push_back((p.cast<double>() + noise + origin).cast<float>());
      source.points.push_back((T_sensors.inverse() * (p.cast<double>() - noise) + origin).cast<float>());
    }
    OrientationPrior prior;
    prior.R_target_source = rotation_about_z(0.44);
    const RegistrationResult result = register_clouds(source, target, origin, prior);
    const Pose truth = Eigen::Translation3d(origin) * T_sensors * Eigen::Translation3d(-origin);
    EXPECT_EQ(result.verdict, Verdict::accepted) << result.reason;
    EXPECT_LT((result.T_target_source * origin - truth * origin).norm(), 0.01);
    EXPECT_LT(rotation_angle(truth.linear().transpose() * result.T_target_source.linear()), 0.003);
  }
}

TEST(Registration, PointsThatAreNoneAndPointsTwiceDoNotTurnARoomAway) {
  const registration::Points room = registration::room(0.06f);
  const Eigen::Vector3f shift(0.5f, 0.3f, 0.0f);
  PointCloud source = cloud_of(room), target = cloud_of(room);
  for (Eigen::Vector3f& p : target.points) p += shift;
  for (std::size_t i = 0; i < room.size(); i += 3) {
    target.points.push_back(target.points[i]);
    source.points[i] = {std::nanf(""), source.points[i].y(), std::numeric_limits<float>::infinity()};
    source.points.push_back({1e30f, -1e30f, 0.0f});
  }
  const RegistrationResult result = register_clouds(source, target);
  EXPECT_EQ(result.verdict, Verdict::accepted) << result.reason;
  EXPECT_LT((result.T_target_source.translation() - shift.cast<double>()).norm(), 0.01);
}

TEST(Registration, SameBytesForEveryNumberOfThreads) {
  PointCloud source = cloud_of(registration::room(0.06f)), target = cloud_of(registration::room(0.07f));
  for (Eigen::Vector3f& p : source.points) p += Eigen::Vector3f(0.4f, 0.3f, 0.0f);
  for (const bool tracked : {true, false}) {
    std::optional<OrientationPrior> prior;
    if (tracked) prior = OrientationPrior{};
    std::vector<RegistrationResult> results;
    for (const std::size_t threads : {1u, 2u, 3u}) {
      const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
      results.push_back(register_clouds(source, target, Eigen::Vector3d::Zero(), prior));
    }
    for (const RegistrationResult& other : results) {
      EXPECT_EQ(results[0].T_target_source.matrix(), other.T_target_source.matrix());
      EXPECT_EQ(results[0].covariance, other.covariance);
      EXPECT_EQ(results[0].probability, other.probability);
      EXPECT_EQ(results[0].reason, other.reason);
    }
  }
}

/// Two walls and a floor along an axis 30 degrees from x, without an end in range; 1 cm of noise.
PointCloud corridor(Random& random) {
  PointCloud cloud;
  const Eigen::Matrix3f R = rotation_about_z(3.14159265358979 / 6.0).cast<float>();
  for (int i = 0; i < 150000; ++i) {
    const auto along = static_cast<float>(120.0 * random.uniform() - 60.0),
               share = static_cast<float>(random.uniform());
    const auto noise = static_cast<float>(0.01 * random.normal());
    Eigen::Vector3f p(along, 1.0f + noise, 2.5f * share - 1.0f);
    if (i % 3 == 1) p.y() = -1.2f + noise;
    if (i % 3 == 2) p = {along, 2.2f * share - 1.2f, -1.0f + noise};
    cloud.points.push_back(R * p);
  }
  return cloud;
}

TEST(Registration, NamesTheDirectionThatACorridorLeavesOpen) {
  Random random(12);
  const PointCloud source = corridor(random), target = corridor(random);
  const RegistrationResult result = register_clouds(source, target);
  EXPECT_EQ(result.verdict, Verdict::refused) << result.reason;
  ASSERT_FALSE(result.open_directions.empty()) << result.reason;
  EXPECT_NE(result.open_directions.front().find("slides along the scene, "), std::string::npos);
  const double degrees = std::stod(result.open_directions.front().substr(24));
  EXPECT_NEAR(degrees, 30.0, 5.0) << result.open_directions.front();
}

}  // namespace
}  // namespace scanway
