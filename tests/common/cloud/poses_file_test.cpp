#include "common/cloud/poses_file.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "common/files/input_error.h"

namespace scanway {
namespace {

const std::string kIdentity = " 1 0 0 0 0 1 0 0 0 0 1 0\n";

std::string poses_error_of(const std::string& text) {
  try {
    PosesFile::parse(text, "poses.txt");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(PosesFile, UsesTheNumbersAsPrinted) {
  const PosesFile poses = PosesFile::parse(
      "# name ...\n\nscan000.pcd 1 0 0 1.5 0 1 0 -2 0 0 1 1e-3 # the first\n"
      "cloud.00001 0.999536236 -0.0140812295 0.0270005863 1.5556691 0.0143726438 0.999840209 -0.0106293556 "
      "0.0374824802 -0.0268465974 0.0110124959 0.999578904 -0.0449462668\r\n",
      "poses.txt");
  EXPECT_EQ(poses.size(), 2u);
  EXPECT_EQ(poses.pose_of("scan000").translation(), Eigen::Vector3d(1.5, -2.0, 1e-3));
  const Pose& X = poses.pose_of("cloud.00001");
  EXPECT_EQ(X.linear()(0, 0), 0.999536236);
  EXPECT_EQ(X.linear()(0, 1), -0.0140812295);
  EXPECT_EQ(X.linear()(2, 0), -0.0268465974);
  EXPECT_EQ(X.translation()(2), -0.0449462668);
  EXPECT_EQ(X.matrix().row(3), Eigen::RowVector4d(0, 0, 0, 1));
}

TEST(PosesFile, MatchesScansByTheirStem) {
  const PosesFile poses = PosesFile::parse("scan000" + kIdentity, "poses.txt");
  EXPECT_NO_THROW(poses.pose_of("scan000"));
  EXPECT_NO_THROW(poses.pose_of("scan000.3d.zst"));
  try {
    poses.pose_of("scan00");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()),
              "poses.txt: has no line for the scan 'scan00'; add one, or leave that scan out");
  }
}

TEST(PosesFile, RefusesWhatIsNoPose) {
  ASSERT_EQ(poses_error_of("a" + kIdentity), "");
  ASSERT_EQ(poses_error_of("a 0.9995 0 0 0 0 1 0 0 0 0 1 0\n"), "");  // Printed with few digits.
  EXPECT_NE(poses_error_of("a 1 0 0 0 0 1 0 0 0 0 1\n").find("poses.txt:1: 11 numbers"), std::string::npos);
  EXPECT_NE(poses_error_of("# c\na 1 0 0 0 0 1 0 0 0 0 1 0 0\n").find("poses.txt:2: 13 numbers"), std::string::npos);
  EXPECT_NE(poses_error_of("a 1 0 0 nan 0 1 0 0 0 0 1 0\n").find("'nan' is not a finite"), std::string::npos);
  EXPECT_NE(poses_error_of("a 1 0 0 1e999 0 1 0 0 0 0 1 0\n").find("finite"), std::string::npos);
  EXPECT_NE(poses_error_of("a 1 0 0 1,5 0 1 0 0 0 0 1 0\n").find("'1,5'"), std::string::npos);
  EXPECT_NE(poses_error_of("a 1.01 0 0 0 0 1 0 0 0 0 1 0\n").find("no rotation"), std::string::npos);
  EXPECT_NE(poses_error_of("a -1 0 0 0 0 1 0 0 0 0 1 0\n").find("no rotation"), std::string::npos);  // A mirror.
  EXPECT_NE(poses_error_of("a 1 0 0 0 1 0 0 0 0 1 0 0\n").find("no rotation"), std::string::npos);
  EXPECT_NE(poses_error_of("a" + kIdentity + "b" + kIdentity + "a" + kIdentity).find(":3: the scan 'a' is there twice"),
            std::string::npos);
  EXPECT_NE(poses_error_of("\x1B[2J 1\n").find(":1: 1 numbers"), std::string::npos);
}

TEST(PosesFile, ReadsThoseOfTheSharedSets) {
  const std::string shared = SCANWAY_SHARED_DIR "/data/";
  if (!std::filesystem::exists(shared)) GTEST_SKIP() << shared << " is not there";
  EXPECT_EQ(PosesFile::read(shared + "hall_scans_a/poses_reference.txt").size(), 7u);
  EXPECT_EQ(PosesFile::read(shared + "handheld_os0_balm/poses_reference.txt").size(), 8u);
  EXPECT_EQ(PosesFile::read(shared + "street_kitti00/poses_reference.txt").size(), 6u);
  EXPECT_NO_THROW(PosesFile::read(shared + "tilted_velodyne_lpm/poses_reference.txt").pose_of("cloud.00002.vtk"));
}

}  // namespace
}  // namespace scanway
