#include <filesystem>

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "tests/bench/registration/real_pairs.h"

namespace scanway {
namespace {

using namespace bench;

const std::string kData = SCANWAY_SHARED_DIR "/data";
constexpr double kDegree = 3.14159265358979 / 180.0;

#define SKIP_WITHOUT_DATA() \
  if (!std::filesystem::exists(kData)) GTEST_SKIP() << kData << " is not there: no real scans to register"

struct Scans {
  RealSet set;
  std::vector<PreparedScan> prepared;
};

Scans prepare(const std::string& name) {
  Scans scans{load_set(kData, name), {}};
  for (const PointCloud& cloud : scans.set.clouds) {
    scans.prepared.push_back(PreparedScan::make(cloud, Eigen::Vector3d::Zero(), {}));
  }
  return scans;
}

void expect_right(const Scans& scans, std::size_t source, std::size_t target,
                  const std::optional<OrientationPrior>& prior, double metres, double degrees) {
  const RegistrationResult result = register_scans(scans.prepared[source], scans.prepared[target], prior, {});
  const PoseError error = error_of(result.T_target_source, scans.set.T_target_source(source, target));
  const std::string pair = scans.set.scans[source] + " to " + scans.set.scans[target] + ": ";
  EXPECT_EQ(result.verdict, Verdict::accepted) << pair << result.reason;
  EXPECT_LT(error.metres, metres) << pair;
  EXPECT_LT(error.radians, degrees * kDegree) << pair;
}

TEST(RealPairs, NeighbouringHallsWithTheTracker) {
  SKIP_WITHOUT_DATA();
  const Scans scans = prepare("hall_scans_a");
  Random random(1);
  for (std::size_t target = 0; target + 1 < scans.prepared.size(); ++target) {
    const Pose truth = scans.set.T_target_source(target + 1, target);
    expect_right(scans, target + 1, target, disturbed_prior(truth, 5.0, 0.5, random), 0.015, 0.1);
  }
}

TEST(RealPairs, NeighboursInTheCorridorWithTheTracker) {
  SKIP_WITHOUT_DATA();
  const Scans scans = prepare("corridor_tilting_sick_3dtk");
  Random random(1);
  for (std::size_t target = 0; target < 2; ++target) {
    const Pose truth = scans.set.T_target_source(target + 1, target);
    expect_right(scans, target + 1, target, disturbed_prior(truth, 5.0, 0.5, random), 0.05, 0.5);
  }
}

TEST(RealPairs, StreetPairWithAndWithoutTheTracker) {
  SKIP_WITHOUT_DATA();
  const Scans scans = prepare("street_pair_hdl32");
  Random random(1);
  expect_right(scans, 1, 0, disturbed_prior(scans.set.T_target_source(1, 0), 5.0, 0.5, random), 0.1, 0.5);
  expect_right(scans, 1, 0, std::nullopt, 0.1, 0.5);
}

TEST(RealPairs, HallAgainstStreetIsRefusedWhateverTheOrientation) {
  SKIP_WITHOUT_DATA();
  const PreparedScan hall = prepare("hall_scans_a").prepared[2], street = prepare("street_pair_hdl32").prepared[0];
  OrientationPrior identity, turned;
  turned.R_target_source = exp_so3({0.3, -0.2, 2.0});
  for (const std::optional<OrientationPrior>& prior :
       {std::optional<OrientationPrior>(identity), std::optional<OrientationPrior>(turned),
        std::optional<OrientationPrior>()}) {
    EXPECT_EQ(register_scans(hall, street, prior, {}).verdict, Verdict::refused);
    EXPECT_EQ(register_scans(street, hall, prior, {}).verdict, Verdict::refused);
  }
}

TEST(RealPairs, ScansThatShareTooLittleAreRefused) {
  SKIP_WITHOUT_DATA();
  const Scans scans = prepare("handheld_os0_balm");
  const std::size_t full092 = 4, full118 = 5;
  ASSERT_EQ(scans.set.scans[full092], "full092");
  ASSERT_EQ(scans.set.scans[full118], "full118");
  Random random(1);
  const auto prior = disturbed_prior(scans.set.T_target_source(full118, full092), 5.0, 0.5, random);
  EXPECT_EQ(register_scans(scans.prepared[full118], scans.prepared[full092], prior, {}).verdict, Verdict::refused);
}

TEST(RealPairs, SameBytesForEveryNumberOfThreads) {
  SKIP_WITHOUT_DATA();
  const RealSet set = load_set(kData, "hall_scans_a");
  Random random(1);
  const OrientationPrior prior = disturbed_prior(set.T_target_source(1, 0), 5.0, 0.5, random);
  std::vector<RegistrationResult> results;
  for (const std::size_t threads : {1u, 2u, 3u}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    const auto source = PreparedScan::make(set.clouds[1], Eigen::Vector3d::Zero(), {});
    const auto target = PreparedScan::make(set.clouds[0], Eigen::Vector3d::Zero(), {});
    results.push_back(register_scans(source, target, prior, {}));
  }
  for (const RegistrationResult& other : results) {
    EXPECT_EQ(results[0].T_target_source.matrix(), other.T_target_source.matrix());
    EXPECT_EQ(results[0].covariance, other.covariance);
    EXPECT_EQ(results[0].probability, other.probability);
    EXPECT_EQ(results[0].overlap, other.overlap);
  }
}

}  // namespace
}  // namespace scanway
