#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <sstream>

#include "common/cloud/poses_file.h"
#include "common/cloud/read_cloud.h"
#include "tests/modules/mapper/core/octomap/support/reference.h"
#include "tests/support/command.h"

namespace scanway {
namespace {

const std::string kSamples = std::string(SCANWAY_SHARED_DIR) + "/data/octomap_samples";
const std::string kHalls = std::string(SCANWAY_SHARED_DIR) + "/data/hall_scans_a";

void expect_liboctomap(const std::vector<MapPoints>& sweeps, const OccupancyTreeConfig& config) {
  const TreeFiles ours = files_of_ours(sweeps, config);
  EXPECT_TRUE(ours == files_of_liboctomap(sweeps, config)) << config.resolution_m << ", " << config.discretize;
  EXPECT_GT(ours.ot.size(), 10000u);
}

TEST(OctomapSamples, TheScanIsThatOfLiboctomap) {
  if (!std::filesystem::exists(kSamples)) GTEST_SKIP() << kSamples << " is not there";
  const auto unpacked = test::run_command({"bzcat", kSamples + "/scan.dat.bz2"});
  if (unpacked.status != 0) GTEST_SKIP() << "bzcat is not there";
  MapPoints sweep;
  std::istringstream numbers(unpacked.out);
  for (float x, y, z; numbers >> x >> y >> z;) sweep.points.emplace_back(x, y, z);
  ASSERT_EQ(sweep.points.size(), 88206u);
  expect_liboctomap({sweep}, {0.1, -1.0, false});
  expect_liboctomap({sweep}, {0.05, 10.0, true});
}

/// The points of the scan graph's only scan: their number, then of each its dimension and three doubles.
std::vector<Eigen::Vector3f> points_of_graph(const std::string& bytes) {
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + 4, 4);
  std::vector<Eigen::Vector3f> points;
  for (std::size_t i = 0, at = 8; i < count && at + 28 <= bytes.size(); ++i, at += 28) {
    double p[3];
    std::memcpy(p, bytes.data() + at + 4, 24);
    points.emplace_back(float(p[0]), float(p[1]), float(p[2]));
  }
  return points;
}

TEST(OctomapSamples, TheSphericalScanIsThatOfLiboctomap) {
  if (!std::filesystem::exists(kSamples)) GTEST_SKIP() << kSamples << " is not there";
  MapPoints sweep;
  sweep.points = points_of_graph(test::read_text(kSamples + "/spherical_scan.graph"));
  ASSERT_EQ(sweep.points.size(), 10201u);
  for (const bool discretize : {false, true}) {
    expect_liboctomap({sweep}, {0.05, -1.0, discretize});
    expect_liboctomap({sweep}, {0.02, 2.0, discretize});
  }
}

TEST(Halls, TwoScansInARowAreThoseOfLiboctomap) {
  if (!std::filesystem::exists(kHalls)) GTEST_SKIP() << kHalls << " is not there";
  const PosesFile poses = PosesFile::read(kHalls + "/poses_reference.txt");
  std::vector<MapPoints> sweeps;
  for (const std::string name : {"scan000", "scan001"}) {
    const Pose& X = poses.pose_of(name);
    MapPoints& sweep = sweeps.emplace_back();
    sweep.origin = X.translation();
    for (const Eigen::Vector3f& p : read_cloud(kHalls + "/" + name + ".pcd").points) {
      sweep.points.push_back(transform_in_order(X, p.cast<double>()).cast<float>());
    }
  }
  expect_liboctomap(sweeps, {0.1, -1.0, false});
  expect_liboctomap(sweeps, {0.2, 20.0, true});
}

}  // namespace
}  // namespace scanway
