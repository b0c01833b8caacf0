#include <gtest/gtest.h>
#include <zstd.h>

#include "tests/common/cloud/sample_files.h"

namespace scanway {
namespace {

using Points = std::vector<Eigen::Vector3f>;

std::string zstd(std::string_view raw) {
  std::string out(ZSTD_compressBound(raw.size()), '\0');
  out.resize(ZSTD_compress(out.data(), out.size(), raw.data(), raw.size(), 3));
  return out;
}

TEST(ReadXyz, ReadsColumns) {
  EXPECT_EQ(read_bytes("a.xyz", "1 2 3\n4 5 6").points, (Points{{1, 2, 3}, {4, 5, 6}}));
  const PointCloud four = read_bytes("a.txt", "# x y z i\n//X Y Z I\n\n1 2 3 9\r\n\t4 5 6 8\n");
  EXPECT_EQ(four.points, (Points{{1, 2, 3}, {4, 5, 6}}));
  EXPECT_EQ(four.intensity, (std::vector<float>{9.0f, 8.0f}));
  EXPECT_TRUE(read_bytes("a.ASC", "1 2 3 255 0 0\n").intensity.empty());
}

TEST(ReadXyz, RefusesLinesThatDiffer) {
  EXPECT_NE(error_of("a.xyz", "1 2\n").find(":1:"), std::string::npos);
  EXPECT_NE(error_of("a.xyz", "1 2 3\n1 2 3 4\n").find(":2:"), std::string::npos);
  EXPECT_NE(error_of("a.xyz", "1 2 3\n1 2\n").find(":2:"), std::string::npos);
  EXPECT_NE(error_of("a.xyz", "1 2 3\n1 2 0x3\n").find("'0x3'"), std::string::npos);
  EXPECT_NE(error_of("a.xyz", "# nothing\n").find("holds no point"), std::string::npos);
  EXPECT_NE(error_of("a.jpeg", "1 2 3\n").find("is no cloud"), std::string::npos);
}

TEST(Read3dtk, TurnsTheLeftHandedCentimetresRound) {
  // One metre to the right, two up, three ahead.
  const PointCloud cloud = read_bytes("scan000.3d", "100 200 300 17\n-100 0 50 18\n");
  EXPECT_EQ(cloud.points, (Points{{3.0f, -1.0f, 2.0f}, {0.5f, 1.0f, 0.0f}}));
  EXPECT_EQ(cloud.intensity, (std::vector<float>{17.0f, 18.0f}));
}

TEST(Read3dtk, LeavesOutMarksOfNoReturn) {
  CloudNotes notes;
  const PointCloud cloud = read_bytes("a.3d", "10.1 0 0\n0 0 3276.7\n0 3275.9 0\n0 0 3200\n0 0 31\n0 0 5000\n", &notes);
  EXPECT_EQ(cloud.points, (Points{{32, 0, 0}, {0.31f, 0, 0}, {50, 0, 0}}));
  EXPECT_EQ(notes.no_return, 3u);
  EXPECT_NE(error_of("a.3d", "10 0 0\n0 0 3276.7\n").find("no finite point"), std::string::npos);
}

TEST(Zstd, IsReadThrough) {
  const std::string text = "100 200 300\n100 200 400\n";
  EXPECT_EQ(read_bytes("a.3d.zst", zstd(text)).size(), 2u);
  EXPECT_EQ(read_bytes("a.xyz.zst", zstd(text) + zstd(text)).size(), 4u);  // Frames one after the other are one file.
  EXPECT_EQ(read_bytes("a.xyz", zstd(text)).size(), 2u);
}

TEST(Zstd, RefusesDamageAndBombs) {
  std::string text;
  for (int i = 0; i < 1000; ++i) text += std::to_string(i * 7919 % 1000) + " 2 3\n";
  const std::string good = zstd(text);
  ASSERT_EQ(error_of("a.xyz.zst", good), "");
  for (std::size_t size = 1; size < good.size(); size += 7) EXPECT_NE(error_of("a.xyz.zst", good.substr(0, size)), "");
  EXPECT_NE(error_of("a.xyz.zst", zstd(std::string(100'000'000, ' '))).find("64 times"), std::string::npos);
}

TEST(ScanName, IsTheStem) {
  EXPECT_EQ(scan_name("a.b/scan000.pcd"), "scan000");
  EXPECT_EQ(scan_name("scan000.3d.zst"), "scan000");
  EXPECT_EQ(scan_name("/x/cloud.00000.vtk"), "cloud.00000");
  EXPECT_EQ(scan_name("cloud.00000"), "cloud.00000");
  EXPECT_EQ(scan_name("A.PLY"), "A");
}

}  // namespace
}  // namespace scanway
