#include <gtest/gtest.h>

#include <filesystem>

#include "common/cloud/read_cloud.h"
#include "common/files/input_error.h"

namespace scanway {
namespace {

/// What the sets' READMEs, and other programs, say of the recorded clouds.
struct RealCloud {
  const char* path;
  std::size_t points;
  bool intensity;
};

class RealClouds : public testing::TestWithParam<RealCloud> {};

TEST_P(RealClouds, HaveThePointsThatTheirSetStates) {
  const std::string path = std::string(SCANWAY_SHARED_DIR "/data/") + GetParam().path;
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not there";
  CloudNotes notes;
  const PointCloud cloud = read_cloud(path, &notes);
  EXPECT_EQ(cloud.size() + notes.not_finite + notes.no_return, GetParam().points);
  EXPECT_EQ(notes.not_finite, 0u);
  EXPECT_EQ(cloud.intensity.size(), GetParam().intensity ? cloud.size() : 0u);
}

INSTANTIATE_TEST_SUITE_P(All, RealClouds,
                         testing::Values(RealCloud{"hall_scans_a/scan000.pcd", 65786, true},
                                         RealCloud{"handheld_os0_balm/full000.pcd", 73452, true},
                                         RealCloud{"street_kitti00/000000.pcd", 124668, true},
                                         RealCloud{"ground_reference_isprs/samp11-utm.pcd", 38010, false},
                                         RealCloud{"street_pair_hdl32/source.ply", 69792, true},
                                         RealCloud{"tilted_velodyne_lpm/cloud.00000.vtk", 24989, false},
                                         RealCloud{"corridor_tilting_sick_3dtk/scan000.3d.zst", 81360, false}));

}  // namespace
}  // namespace scanway
