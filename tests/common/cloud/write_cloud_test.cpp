#include "common/cloud/write_cloud.h"

#include <gtest/gtest.h>

#include "common/random/random.h"
#include "tests/common/cloud/sample_files.h"

namespace scanway {
namespace {

PointCloud random_cloud(std::size_t points, bool intensity) {
  Random random(points);
  PointCloud cloud;
  for (std::size_t i = 0; i < points; ++i) {
    cloud.points.emplace_back(static_cast<float>(random.normal()), static_cast<float>(random.normal()),
                              static_cast<float>(random.normal()));
    if (intensity) cloud.intensity.push_back(static_cast<float>(random.uniform()));
  }
  return cloud;
}

TEST(WriteCloud, ComesBackBitForBit) {
  const test::ScratchFolder folder;
  for (const bool intensity : {false, true}) {
    const PointCloud cloud = random_cloud(70'000, intensity);  // More than a block.
    for (const std::string name : {"a.pcd", "a.ply"}) {
      name == "a.pcd" ? write_pcd(folder / name, cloud) : write_ply(folder / name, cloud);
      const PointCloud back = read_cloud(folder / name);
      EXPECT_EQ(back.points, cloud.points) << name;
      EXPECT_EQ(back.intensity, cloud.intensity) << name;
    }
  }
}

TEST(WriteCloud, WritesTheseBytes) {
  const test::ScratchFolder folder;
  PointCloud cloud;
  cloud.points = {{1.0f, 2.0f, 3.0f}};
  cloud.intensity = {4.0f};
  const std::string row = little(1.0f) + little(2.0f) + little(3.0f) + little(4.0f);
  write_pcd(folder / "a.pcd", cloud);
  EXPECT_EQ(test::read_text(folder / "a.pcd"),
            "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS x y z intensity\nSIZE 4 4 4 4\n"
            "TYPE F F F F\nCOUNT 1 1 1 1\nWIDTH 1\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 1\nDATA binary\n" +
                row);
  write_ply(folder / "a.ply", cloud);
  EXPECT_EQ(test::read_text(folder / "a.ply"),
            "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
            "property float z\nproperty float intensity\nend_header\n" +
                row);
}

TEST(WriteCloud, WritesNormalsAfterTheRest) {
  const test::ScratchFolder folder;
  PointCloud cloud;
  cloud.points = {{1.0f, 2.0f, 3.0f}};
  cloud.normals = {{0.0f, 0.0f, 1.0f}};
  const std::string row = little(1.0f) + little(2.0f) + little(3.0f) + little(0.0f) + little(0.0f) + little(1.0f);
  write_pcd(folder / "a.pcd", cloud);
  EXPECT_EQ(test::read_text(folder / "a.pcd"),
            "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS x y z normal_x normal_y normal_z\n"
            "SIZE 4 4 4 4 4 4\nTYPE F F F F F F\nCOUNT 1 1 1 1 1 1\nWIDTH 1\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\n"
            "POINTS 1\nDATA binary\n" +
                row);
  write_ply(folder / "a.ply", cloud);
  EXPECT_EQ(test::read_text(folder / "a.ply"),
            "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
            "property float z\nproperty float nx\nproperty float ny\nproperty float nz\nend_header\n" +
                row);
}

TEST(WriteCloud, WritesPartsAsTheWhole) {
  const test::ScratchFolder folder;
  const PointCloud first = random_cloud(70'000, true), second = random_cloud(3, false), third = random_cloud(5, true);
  PointCloud whole;
  for (const PointCloud* part : {&first, &second, &third}) {
    whole.points.insert(whole.points.end(), part->points.begin(), part->points.end());
    whole.intensity.insert(whole.intensity.end(), part->intensity.begin(), part->intensity.end());
    whole.intensity.resize(whole.points.size());
  }
  write_pcd(folder / "whole.pcd", whole);
  CloudWriter writer(folder / "parts.pcd", CloudWriter::Format::pcd, {whole.size(), true, false});
  writer.write(first);
  writer.write(second);
  EXPECT_THROW(writer.commit(), std::logic_error);
  writer.write(third);
  writer.commit();
  EXPECT_EQ(test::read_text(folder / "parts.pcd"), test::read_text(folder / "whole.pcd"));
}

TEST(WriteCloud, SaysWhereItCannotWrite) {
  const test::ScratchFolder folder;
  const std::string path = write_file_in(folder, "file", "") + "/map.pcd";
  EXPECT_THROW(write_pcd(path, random_cloud(3, false)), InputError);
  EXPECT_NO_THROW(write_pcd(folder / "map.pcd", PointCloud{}));
}

}  // namespace
}  // namespace scanway
