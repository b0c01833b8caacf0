#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "common/cloud/read_cloud.h"
#include "common/files/input_error.h"

namespace scanway {
namespace {

/// Recorded clouds and the sums of their coordinates and intensities, computed with PCL (PCD) and with a script of
/// twenty lines (the others).
struct RealCloud {
  const char* path;
  std::size_t points;
  std::size_t no_return;
  double x, y, z, intensity;
};

class RealClouds : public testing::TestWithParam<RealCloud> {};

TEST_P(RealClouds, AreReadAsOtherProgramsReadThem) {
  const RealCloud& expected = GetParam();
  const std::string path = std::string(SCANWAY_SHARED_DIR "/data/") + expected.path;
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not there";
  CloudNotes notes;
  const PointCloud cloud = read_cloud(path, &notes);
  Eigen::Vector4d sum = Eigen::Vector4d::Zero();
  for (const Eigen::Vector3f& p : cloud.points) sum.head<3>() += p.cast<double>();
  for (const float intensity : cloud.intensity) sum[3] += intensity;
  EXPECT_EQ(cloud.size(), expected.points);
  EXPECT_EQ(notes.not_finite, 0u);
  EXPECT_EQ(notes.no_return, expected.no_return);
  EXPECT_NEAR(sum[0], expected.x, std::abs(expected.x) * 1e-7);
  EXPECT_NEAR(sum[1], expected.y, std::abs(expected.y) * 1e-7);
  EXPECT_NEAR(sum[2], expected.z, std::abs(expected.z) * 1e-7);
  EXPECT_NEAR(sum[3], expected.intensity, std::abs(expected.intensity) * 1e-7);
}

INSTANTIATE_TEST_SUITE_P(
    All, RealClouds,
    testing::Values(
        RealCloud{"hall_scans_a/scan000.pcd", 65786, 0, 203998.53, 368561.91, -11467.8259, 6963121.38},
        RealCloud{"handheld_os0_balm/full000.pcd", 73452, 0, 107116.774, 32300.9782, 37139.2014, 3458985},
        RealCloud{"street_kitti00/000000.pcd", 124668, 0, -178942.814, 127768.874, -150940.371, 9350620.52},
        RealCloud{"ground_reference_isprs/samp11-utm.pcd", 38010, 0, 1.94902741e10, 2.05394926e11, 13538076.2, 0},
        RealCloud{"ground_reference_isprs/samp53-utm-ground.pcd", 32989, 0, 1.63260972e10, 1.78818803e11, 9454972.2, 0},
        RealCloud{"street_pair_hdl32/source.ply", 69792, 0, 19072.4907, -75793.3127, -43291.9931, 2134792},
        RealCloud{"tilted_velodyne_lpm/cloud.00000.vtk", 24989, 0, 21152.7229, -10166.1328, 95361.438, 0},
        RealCloud{"corridor_tilting_sick_3dtk/scan000.3d.zst", 77906, 3454, 128781.057, 68740.2541, 46996.1424, 0}));

}  // namespace
}  // namespace scanway
