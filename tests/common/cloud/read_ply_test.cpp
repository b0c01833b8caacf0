#include <gtest/gtest.h>

#include "tests/common/cloud/sample_files.h"

namespace scanway {
namespace {

using Points = std::vector<Eigen::Vector3f>;

const std::string kXyz = "property float x\nproperty float y\nproperty float z\n";

std::string header(const std::string& format, const std::string& elements) {
  return "ply\nformat " + format + " 1.0\ncomment by hand\nobj_info none\n" + elements + "end_header\n";
}

/// One vertex with every type of property, a list before it and faces after it, in either byte order.
template <class Bytes>
std::string mixed_binary(const std::string& format, const Bytes& bytes) {
  const std::string elements =
      "element camera 1\nproperty uchar a\nproperty list uchar short b\n"
      "element vertex 2\nproperty char c\nproperty double z\nproperty uchar u\nproperty short y\n"
      "property ushort us\nproperty int i32\nproperty uint u32\nproperty float Intensity\nproperty int8 x\n"
      "element face 1\nproperty list uint8 int32 vertex_indices\n";
  std::string body = bytes(std::uint8_t{9}) + bytes(std::uint8_t{2}) + bytes(std::int16_t{1}) + bytes(std::int16_t{2});
  for (const int k : {1, 2}) {
    body += bytes(std::int8_t{1}) + bytes(0.5 * k) + bytes(std::uint8_t{2}) +
            bytes(static_cast<std::int16_t>(-300 * k)) + bytes(std::uint16_t{3}) + bytes(std::int32_t{4}) +
            bytes(std::uint32_t{5}) + bytes(100.0f * static_cast<float>(k)) + bytes(static_cast<std::int8_t>(-k));
  }
  body += bytes(std::uint8_t{3}) + bytes(std::int32_t{0}) + bytes(std::int32_t{1}) + bytes(std::int32_t{0});
  return header(format, elements) + body;
}

void expect_mixed(const PointCloud& cloud) {
  EXPECT_EQ(cloud.points, (Points{{-1.0f, -300.0f, 0.5f}, {-2.0f, -600.0f, 1.0f}}));
  EXPECT_EQ(cloud.intensity, (std::vector<float>{100.0f, 200.0f}));
}

TEST(ReadPly, TakesEveryTypeInBothByteOrders) {
  expect_mixed(read_bytes("a.ply", mixed_binary("binary_little_endian", [](auto v) { return little(v); })));
  expect_mixed(read_bytes("a.ply", mixed_binary("binary_big_endian", [](auto v) { return big(v); })));
}

TEST(ReadPly, SeesThatElementsAfterTheVerticesAreCut) {
  const std::string whole = mixed_binary("binary_little_endian", [](auto v) { return little(v); });
  EXPECT_NE(error_of("a.ply", whole.substr(0, whole.size() - 1)).find("element 'face'"), std::string::npos);
}

TEST(ReadPly, SkipsListsWithinAVertex) {
  const std::string elements =
      "element vertex 2\nproperty float x\nproperty list int ushort views\nproperty float y\nproperty float z\n";
  const std::string body = little(1.0f) + little(std::int32_t{2}) + "abcd" + little(2.0f) + little(3.0f) +  //
                           little(4.0f) + little(std::int32_t{0}) + little(5.0f) + little(6.0f);
  const std::string head = header("binary_little_endian", elements);
  EXPECT_EQ(read_bytes("a.ply", head + body).points, (Points{{1, 2, 3}, {4, 5, 6}}));
  EXPECT_EQ(read_bytes("a.ply", header("ascii", elements) + "1 2 7 8 2 3\n4 0 5 6\n").points,
            (Points{{1, 2, 3}, {4, 5, 6}}));
  const std::string negative =
      little(1.0f) + little(std::int32_t{-1}) + little(2.0f) + little(3.0f) + std::string(16, 0);
  EXPECT_NE(error_of("a.ply", head + negative), "");
  const std::string huge = little(1.0f) + little(std::int32_t{0x7FFFFFFF}) + little(2.0f) + std::string(20, 0);
  EXPECT_NE(error_of("a.ply", head + huge), "");
}

TEST(ReadPly, ReadsText) {
  const std::string elements = "element camera 1\nproperty list uchar float a\nelement vertex 2\n" + kXyz +
                               "property uchar reflectance\nelement face 1\nproperty list uchar int i\n";
  const PointCloud cloud = read_bytes("a.ply", header("ascii", elements) + "2 0 1\n1 2 3 4\n\n5 6 7 8\n3 0 1 0\n");
  EXPECT_EQ(cloud.points, (Points{{1, 2, 3}, {5, 6, 7}}));
  EXPECT_EQ(cloud.intensity, (std::vector<float>{4.0f, 8.0f}));
}

TEST(ReadPly, RefusesDamagedHeaders) {
  const std::string vertex = "element vertex 1\n" + kXyz;
  const auto error = [](const std::string& head) { return error_of("a.ply", head + "1 2 3\n"); };
  ASSERT_EQ(error(header("ascii", vertex)), "");
  EXPECT_NE(error(header("utf16", vertex)).find("'utf16'"), std::string::npos);
  EXPECT_NE(error("ply\n" + vertex + "end_header\n").find("names no format"), std::string::npos);
  EXPECT_NE(error("ply\nformat ascii 1.0\n" + vertex).find(":7: '1'"), std::string::npos);
  EXPECT_NE(error(header("ascii", "property float x\n" + vertex)).find(":5:"), std::string::npos);
  EXPECT_NE(error(header("ascii", "element vertex many\n" + kXyz)).find("has no count"), std::string::npos);
  EXPECT_NE(error(header("ascii", "element vertex 1\nproperty quad x\n")).find("'quad'"), std::string::npos);
  EXPECT_NE(error(header("ascii", "element vertex 1\nproperty list float int x\n")).find("fraction"),
            std::string::npos);
  EXPECT_NE(error(header("ascii", "element vertex 1\nproperty float\n")).find("no name"), std::string::npos);
  EXPECT_NE(error(header("ascii", "element face 1\n" + kXyz)).find("no element vertex"), std::string::npos);
  EXPECT_NE(error(header("ascii", "element vertex 1\n")).find("has no field x"), std::string::npos);
  EXPECT_NE(error(header("ascii", "element vertex 0\n" + kXyz)).find("holds no point"), std::string::npos);
  EXPECT_NE(error(header("ascii", "element vertex 2\n" + kXyz)).find("holds 1"), std::string::npos);
  EXPECT_NE(error("plyx\n"), "");
}

TEST(ReadPly, RefusesWhatItsLengthCannotHold) {
  const auto error = [](const std::string& format, const std::string& count) {
    return error_of("a.ply", header(format, "element vertex " + count + "\n" + kXyz) + "1 2 3 4 5 6\n");
  };
  for (const std::string count : {"4000000000", "18446744073709551615", "6148914691236517206"}) {
    EXPECT_NE(error("binary_little_endian", count), "") << count;
    EXPECT_NE(error("ascii", count), "") << count;
  }
  // Elements without a property take no byte each: their number may be any.
  const std::string none = header("ascii", "element nothing 18446744073709551615\nelement vertex 1\n" + kXyz);
  EXPECT_EQ(error_of("a.ply", none + "1 2 3\n"), "");
  EXPECT_NE(error_of("a.ply", header("ascii", "element vertex 1\n" + kXyz) + "1 2 3 4\n").find("more numbers"),
            std::string::npos);
  EXPECT_NE(error_of("a.ply", header("ascii", "element vertex 1\n" + kXyz) + "1 2\n").find("fewer numbers"),
            std::string::npos);
}

}  // namespace
}  // namespace scanway
