#include <gtest/gtest.h>

#include <limits>

#include "tests/common/cloud/sample_files.h"

namespace scanway {
namespace {

using Points = std::vector<Eigen::Vector3f>;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

std::string header(const std::string& fields, const std::string& sizes, const std::string& types,
                   const std::string& counts, int points, const std::string& data) {
  return "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS " + fields + "\nSIZE " + sizes + "\nTYPE " +
         types + "\nCOUNT " + counts + "\nWIDTH " + std::to_string(points) +
         "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " + std::to_string(points) + "\nDATA " + data + "\n";
}

std::string xyz_header(int points, const std::string& data) {
  return header("x y z", "4 4 4", "F F F", "1 1 1", points, data);
}

class PclSamples : public testing::TestWithParam<const char*> {};

TEST_P(PclSamples, AreReadAsPclWroteThem) {
  const PointCloud cloud = read_cloud(std::string(SCANWAY_SOURCE_DIR "/tests/common/cloud/data/") + GetParam());
  ASSERT_EQ(cloud.size(), 100u);
  ASSERT_EQ(cloud.intensity.size(), 100u);
  for (int i = 0; i < 100; ++i) {
    const auto n = static_cast<float>(i);
    const Eigen::Vector3f expected(0.25f * n - 10.0f, 0.5f * static_cast<float>(i * 7 % 13),
                                   0.125f * static_cast<float>(i % 5) - 0.5f);
    EXPECT_EQ(cloud.points[static_cast<std::size_t>(i)], expected) << i;
    EXPECT_EQ(cloud.intensity[static_cast<std::size_t>(i)], n);
  }
}

INSTANTIATE_TEST_SUITE_P(All, PclSamples,
                         testing::Values("pcl_ascii.pcd", "pcl_binary.pcd", "pcl_compressed.pcd", "pcl_ascii.ply",
                                         "pcl_binary.ply"));

TEST(ReadPcd, TakesFieldsInAnyOrderSizeAndType) {
  const std::string head = header("z rgb _ y I x", "8 4 1 2 1 4", "F F U I U F", "1 1 3 1 1 1", 2, "binary");
  std::string body;
  for (const int k : {1, 2}) {
    body += little(1.5 * k) + little(0.0f) + "pad" + little(static_cast<std::int16_t>(-7 * k)) +
            little(static_cast<std::uint8_t>(250 + k)) + little(0.25f * static_cast<float>(k));
  }
  const PointCloud cloud = read_bytes("a.pcd", head + body);
  EXPECT_EQ(cloud.points, (Points{{0.25f, -7.0f, 1.5f}, {0.5f, -14.0f, 3.0f}}));
  EXPECT_EQ(cloud.intensity, (std::vector<float>{251.0f, 252.0f}));
}

TEST(ReadPcd, TakesEveryNumberType) {
  const auto read_x = [](const std::string& size, const std::string& type, const std::string& x) {
    const std::string head = header("x y z", size + " 4 4", type + " F F", "1 1 1", 1, "binary");
    return read_bytes("a.pcd", head + x + little(0.0f) + little(0.0f)).points.at(0).x();
  };
  EXPECT_EQ(read_x("1", "I", little(std::int8_t{-128})), -128.0f);
  EXPECT_EQ(read_x("1", "U", little(std::uint8_t{200})), 200.0f);
  EXPECT_EQ(read_x("2", "I", little(std::int16_t{-30000})), -30000.0f);
  EXPECT_EQ(read_x("2", "U", little(std::uint16_t{60000})), 60000.0f);
  EXPECT_EQ(read_x("4", "I", little(std::int32_t{-70000})), -70000.0f);
  EXPECT_EQ(read_x("4", "U", little(std::uint32_t{3000000000u})), 3e9f);
  EXPECT_EQ(read_x("8", "I", little(std::int64_t{-5000000000})), -5e9f);
  EXPECT_EQ(read_x("8", "U", little(std::uint64_t{1} << 63)), 0x1p63f);
  EXPECT_EQ(read_x("4", "F", little(1.25f)), 1.25f);
  EXPECT_EQ(read_x("8", "F", little(-1e-3)), -1e-3f);
}

TEST(ReadPcd, ReadsTextWithBlankLinesAndWindowsLineEnds) {
  EXPECT_EQ(read_bytes("a.pcd", xyz_header(2, "ascii") + "1 2 3\r\n\r\n  -1e-1\t+0.5 .25 \r\n").points,
            (Points{{1.0f, 2.0f, 3.0f}, {-0.1f, 0.5f, 0.25f}}));
  std::string windows = xyz_header(1, "binary");
  for (std::size_t at = 0; (at = windows.find('\n', at)) != std::string::npos; at += 2) windows.replace(at, 1, "\r\n");
  EXPECT_EQ(read_bytes("a.pcd", windows + little(1.0f) + little(2.0f) + little(3.0f)).points, (Points{{1, 2, 3}}));
}

TEST(ReadPcd, ReadsOldAndShortHeaders) {
  EXPECT_EQ(read_bytes("a.pcd", "COLUMNS x y z\nSIZE 4 4 4\nTYPE F F F\nPOINTS 1\nDATA ascii\n1 2 3").size(), 1u);
  EXPECT_EQ(read_bytes("a.pcd", "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 1\nHEIGHT 1\nDATA ascii\n1 2 3").size(),
            1u);
}

TEST(ReadPcd, KnowsAPcdByItsContent) {
  EXPECT_EQ(read_bytes("cloud", xyz_header(1, "ascii") + "1 2 3\n").size(), 1u);
  EXPECT_EQ(read_bytes("cloud.ply", xyz_header(1, "ascii") + "1 2 3\n").size(), 1u);
}

TEST(ReadPcd, LeavesOutPointsThatAreNotFinite) {
  CloudNotes notes;
  const PointCloud cloud = read_bytes("a.pcd",
                                      header("x y z intensity", "4 4 4 4", "F F F F", "1 1 1 1", 5, "ascii") +
                                          "nan 1 2 3\n1 2 3 4\n1 -inf 2 5\n1 2 1e99 6\n4 5 6 nan\n",
                                      &notes);
  EXPECT_EQ(cloud.points, (Points{{1, 2, 3}, {4, 5, 6}}));
  EXPECT_EQ(cloud.intensity, (std::vector<float>{4.0f, 0.0f}));
  EXPECT_EQ(notes.not_finite, 3u);
  EXPECT_EQ(notes.sentence(), "left out 3 points that are not finite");
  std::string body;
  for (const float value : {kNan, 1.0f, 2.0f, 3.0f, 4.0f, 5.0f}) body += little(value);
  EXPECT_EQ(read_bytes("a.pcd", xyz_header(2, "binary") + body).points, (Points{{3, 4, 5}}));
}

TEST(ReadPcd, RefusesACloudWithoutAPoint) {
  EXPECT_NE(error_of("a.pcd", xyz_header(0, "ascii")).find("holds no point"), std::string::npos);
  EXPECT_NE(error_of("a.pcd", xyz_header(0, "binary")).find("holds no point"), std::string::npos);
  EXPECT_NE(error_of("a.pcd", xyz_header(1, "ascii") + "nan nan nan\n").find("no finite point"), std::string::npos);
  EXPECT_NE(error_of("a.pcd", "").find("is empty"), std::string::npos);
  EXPECT_EQ(error_of("a.pcd", xyz_header(1, "ascii") + "0 0 0\n"), "");
}

struct Damage {
  const char* what;      ///< Of the header or body, replaced ...
  const char* by;        ///< ... by this.
  const char* expected;  ///< In the message.
};

class DamagedPcd : public testing::TestWithParam<Damage> {};

TEST_P(DamagedPcd, IsRefusedWithItsReason) {
  std::string text = xyz_header(2, "ascii") + "1 2 3\n4 5 6\n";
  ASSERT_EQ(error_of("a.pcd", text), "");
  const std::size_t at = text.find(GetParam().what);
  ASSERT_NE(at, std::string::npos);
  text.replace(at, std::string(GetParam().what).size(), GetParam().by);
  const std::string error = error_of("a.pcd", text);
  EXPECT_NE(error.find(GetParam().expected), std::string::npos) << error;
  EXPECT_NE(error.find("a.pcd"), std::string::npos) << error;
  EXPECT_EQ(error.find('\n'), std::string::npos) << error;
}

INSTANTIATE_TEST_SUITE_P(
    All, DamagedPcd,
    testing::Values(Damage{"FIELDS x y z", "FIELDS x q z", "has no field y"},
                    Damage{"FIELDS x y z", "FIELDS x x z", "has the field x twice"},
                    Damage{"FIELDS x y z\n", "", "no FIELDS"}, Damage{"SIZE 4 4 4", "SIZE 4 4", ":4: this line"},
                    Damage{"SIZE 4 4 4", "SIZE 4 3 4", "SIZE '3'"}, Damage{"TYPE F F F", "TYPE F F X", "TYPE 'X'"},
                    Damage{"SIZE 4 4 4", "SIZE 2 4 4", "SIZE '2'"}, Damage{"COUNT 1 1 1", "COUNT 1 -1 1", "COUNT"},
                    Damage{"COUNT 1 1 1", "COUNT 1 2 1", "COUNT 2"}, Damage{"WIDTH 2", "WIDTH two", ":7: 'two'"},
                    Damage{"WIDTH 2", "WIDTH 3", "do not fit together"},
                    Damage{"HEIGHT 1", "HEIGHT 99999999999999999999", "is no number of points"},
                    Damage{"HEIGHT 1", "HEIGHT 18446744073709551615", "do not fit together"},
                    Damage{"POINTS 2", "SURPRISE 2", ":10: 'SURPRISE'"}, Damage{"POINTS 2", "WIDTH 2", "WIDTH twice"},
                    Damage{"DATA ascii", "DATA zip", "DATA 'zip'"}, Damage{"DATA ascii\n", "", "is no entry"},
                    Damage{"4 5 6\n", "", "holds 1; it is cut"},
                    Damage{"4 5 6", "4 5", ":13: this point has 2 numbers in place of 3"},
                    Damage{"4 5 6", "4 5 6 7", ":13: this point has 4"}, Damage{"4 5 6", "4 5,5 6", "'5,5'"},
                    Damage{"4 5 6", "4 \x1B[2J 6", "'\\x1B[2J'"}, Damage{"4 5 6", "4 5 6\n7 8 9", "more points"}));

TEST(ReadPcd, RefusesWhatItsLengthCannotHold) {
  const std::string body(24, '\0');
  ASSERT_EQ(error_of("a.pcd", xyz_header(2, "binary") + body), "");
  EXPECT_NE(error_of("a.pcd", xyz_header(2, "binary") + body.substr(1)), "");
  EXPECT_NE(error_of("a.pcd", xyz_header(2'000'000'000, "binary") + body), "");
  EXPECT_NE(error_of("a.pcd", xyz_header(2'000'000'000, "ascii") + "1 2 3\n"), "");
  const std::string wide = header("x y z n", "4 4 4 8", "F F F F", "1 1 1 4294967295", 2, "binary");
  EXPECT_NE(error_of("a.pcd", wide + body), "");
}

/// Data of `raw` in LZF without any repetition: runs of at most 32 bytes as they are.
std::string lzf_literals(std::string_view raw) {
  std::string out;
  for (std::size_t at = 0; at < raw.size(); at += 32) {
    const std::string_view run = raw.substr(at, 32);
    out += static_cast<char>(run.size() - 1);
    out += run;
  }
  return out;
}

std::string compressed(std::string_view lzf, std::uint32_t raw_size) {
  std::string out = little(static_cast<std::uint32_t>(lzf.size())) + little(raw_size);
  out += lzf;
  return out;
}

TEST(ReadPcd, ReadsCompressedFieldsOneAfterTheOther) {
  std::string raw;
  for (const float value : {1.0f, 4.0f, 2.0f, 5.0f, 3.0f, 6.0f}) raw += little(value);
  const std::string good = compressed(lzf_literals(raw), 24);
  EXPECT_EQ(read_bytes("a.pcd", xyz_header(2, "binary_compressed") + good).points, (Points{{1, 2, 3}, {4, 5, 6}}));
  // 24 equal bytes: one as it is, then "copy 23 from one before".
  const std::string runs = {'\0', '\x3F', static_cast<char>(0xE0), 23 - 2 - 7, 0};
  EXPECT_EQ(read_bytes("a.pcd", xyz_header(2, "binary_compressed") + compressed(runs, 24)).points[1],
            Eigen::Vector3f::Constant(std::bit_cast<float>(0x3F3F3F3F)));
}

TEST(ReadPcd, RefusesDamagedCompression) {
  const std::string head = xyz_header(2, "binary_compressed");
  const auto error = [&](const std::string& lzf, std::uint32_t size) {
    return error_of("a.pcd", head + compressed(lzf, size));
  };
  const std::string good = lzf_literals(std::string(24, '\1'));
  ASSERT_EQ(error(good, 24), "");
  EXPECT_NE(error(good, 25), "");
  EXPECT_NE(error(good, 12), "");
  EXPECT_NE(error(good.substr(0, 20), 24), "");
  EXPECT_NE(error(good + '\0', 24), "");
  EXPECT_NE(error({static_cast<char>(0xE0), 20, 0}, 24), "");              // Copies from before the beginning.
  EXPECT_NE(error({'\0', 'a', static_cast<char>(0xE0), 100, 0}, 24), "");  // Copies past the end.
  EXPECT_NE(error({'\0', 'a', static_cast<char>(0xE0)}, 24), "");          // Cut within a copy.
  EXPECT_NE(error_of("a.pcd", head + "\1\2\3"), "");
  const std::string promise = xyz_header(300'000'000, "binary_compressed");
  EXPECT_NE(error_of("a.pcd", promise + compressed(good, 3'600'000'000u)), "");
}

}  // namespace
}  // namespace scanway
