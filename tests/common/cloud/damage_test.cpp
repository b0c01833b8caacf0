#include <gtest/gtest.h>

#include <algorithm>

#include "common/random/random.h"
#include "tests/common/cloud/sample_files.h"

namespace scanway {
namespace {

/// A small valid file of each format.
struct Sample {
  std::string name;
  std::string bytes;
};

std::string data_file(const std::string& name) {
  return test::read_text(SCANWAY_SOURCE_DIR "/tests/common/cloud/data/" + name);
}

std::vector<Sample> samples() {
  const std::string vtk = "# vtk DataFile Version 3.0\nt\n";
  std::string floats;
  for (int i = 0; i < 30; ++i) floats += big(static_cast<float>(i));
  std::string faces =
      "ply\nformat binary_big_endian 1.0\nelement vertex 3\nproperty float x\nproperty list uchar int l\n";
  faces += "property double y\nproperty short z\nelement face 2\nproperty list uint uchar i\nend_header\n";
  for (int i = 0; i < 3; ++i) faces += big(1.0f) + '\1' + big(7) + big(2.0) + big(std::int16_t{3});
  faces += big(3u) + "abc" + big(1u) + "a";
  return {{"a.pcd", data_file("pcl_ascii.pcd").substr(0, 400)},
          {"b.pcd", data_file("pcl_ascii.pcd")},
          {"c.pcd", data_file("pcl_binary.pcd")},
          {"d.pcd", data_file("pcl_compressed.pcd")},
          {"e.ply", data_file("pcl_ascii.ply")},
          {"f.ply", data_file("pcl_binary.ply")},
          {"g.ply", faces},
          {"h.vtk", vtk + "ASCII\nDATASET POLYDATA\nFIELD f 1\nT 1 1 int\n4\nPOINTS 3 float\n1 2 3\n4 5 6\n7 8 9\n"},
          {"i.vtk", vtk + "BINARY\nDATASET POLYDATA\nPOINTS 10 float\n" + floats + "\n"},
          {"j.xyz", "1 2 3 4\n-5.5 6e-1 .7 8\n"},
          {"k.3d", "100 200 300\n-100 0 50\n"}};
}

/// Reads the bytes, whatever they are: a cloud of no more points than there are bytes, or an error of one clean line.
/// Says whether it was a cloud.
bool read_anything(const std::string& name, const std::string& bytes) {
  try {
    const PointCloud cloud = parse_cloud(bytes, name);
    EXPECT_FALSE(cloud.empty());
    EXPECT_LE(cloud.size(), bytes.size() * 100);
    EXPECT_TRUE(cloud.intensity.empty() || cloud.intensity.size() == cloud.size());
    for (const Eigen::Vector3f& p : cloud.points) EXPECT_TRUE(p.allFinite());
    return true;
  } catch (const InputError& error) {
    const std::string text = error.what();
    EXPECT_EQ(text.compare(0, name.size(), name), 0) << text;
    EXPECT_TRUE(std::all_of(text.begin(), text.end(), [](unsigned char c) { return c >= 0x20 && c != 0x7F; })) << text;
    return false;
  }
}

TEST(DamagedCloud, CutAnywhereIsRefusedOrRead) {
  for (const Sample& sample : samples()) {
    for (std::size_t size = 0; size <= sample.bytes.size(); ++size) {
      read_anything(sample.name, sample.bytes.substr(0, size));
    }
  }
}

TEST(DamagedCloud, CutBinaryIsAlwaysRefused) {
  for (const Sample& sample : samples()) {
    if (sample.name != "c.pcd" && sample.name != "d.pcd" && sample.name != "f.ply" && sample.name != "g.ply") continue;
    ASSERT_TRUE(read_anything(sample.name, sample.bytes)) << sample.name;
    for (std::size_t size = 0; size < sample.bytes.size(); ++size) {
      EXPECT_FALSE(read_anything(sample.name, sample.bytes.substr(0, size))) << sample.name << ' ' << size;
    }
  }
}

TEST(DamagedCloud, FlippedBitsAreRefusedOrRead) {
  Random random(7);
  for (const Sample& sample : samples()) {
    for (int trial = 0; trial < 5000; ++trial) {
      std::string bytes = sample.bytes;
      const std::uint64_t flips = 1 + random.below(4);
      for (std::uint64_t k = 0; k < flips; ++k)
        bytes[random.below(bytes.size())] ^= static_cast<char>(1 << random.below(8));
      read_anything(sample.name, bytes);
    }
  }
}

TEST(DamagedCloud, ShuffledPartsAreRefusedOrRead) {
  Random random(8);
  for (const Sample& sample : samples()) {
    for (int trial = 0; trial < 2000; ++trial) {
      std::string bytes = sample.bytes;
      const std::size_t from = random.below(bytes.size());
      const std::size_t length = random.below(bytes.size() - from) % 64 + 1;
      const std::string part = bytes.substr(from, length);
      switch (random.below(4)) {
        case 0:
          bytes.erase(from, length);
          break;
        case 1:
          bytes.insert(random.below(bytes.size()), part);
          break;
        case 2:
          std::fill_n(bytes.begin() + static_cast<std::ptrdiff_t>(from), part.size(), '9');
          break;
        default:
          bytes.insert(from, std::string(length, static_cast<char>(random.below(256))));
      }
      read_anything(sample.name, bytes);
    }
  }
}

}  // namespace
}  // namespace scanway
