#include "common/grid/map_file.h"

#include <algorithm>
#include <clocale>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/files/input_error.h"
#include "common/grid/bounds.h"
#include "common/random/random.h"

namespace scanway {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class MapFile : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(testing::TempDir()) / (std::string("map_file_") + test->name());
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  void put(const std::string& name, const std::string& bytes) const {
    std::ofstream(path(name), std::ios::binary) << bytes;
  }
  std::string get(const std::string& name) const {
    std::ifstream in(path(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  CostMap read(const std::string& yaml, const std::string& pgm) const {
    put("m.yaml", yaml);
    put("m.pgm", pgm);
    return read_map(path("m.yaml"));
  }
  std::string error_of(const std::string& yaml, const std::string& pgm) const {
    try {
      read(yaml, pgm);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  }

  fs::path folder_;
};

const std::string kYaml =
    "image: m.pgm\nresolution: 0.05\norigin: [-1.5, 2.25, 0.0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n";
const std::string kPgm = std::string("P5\n3 2\n255\n") + '\x00' + '\xfe' + '\xcd' + '\xff' + '\x59' + '\x5a';

/// The states row by row from the lowest y: u, f, o.
std::string states(const CostMap& map, int width, int height) {
  std::string text;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) text += "ufo"[static_cast<int>(map.state({x, y}))];
  }
  return text;
}

CostMap random_map(std::uint64_t seed) {
  Random random(seed);
  CostMap map{0.01 * static_cast<double>(1 + random.below(9)), random.normal(), 100 * random.normal(), {}};
  const auto width = 1 + random.below(300), height = 1 + random.below(300);
  const auto x = static_cast<std::int32_t>(random.below(1000)) - 500,
             y = static_cast<std::int32_t>(random.below(1000)) - 500;
  for (int i = 0; i < 500; ++i) {
    const Cell cell{x + static_cast<std::int32_t>(random.below(width)),
                    y + static_cast<std::int32_t>(random.below(height))};
    map.set_state(cell, random.below(2) == 0 ? CellState::free : CellState::occupied);
  }
  return map;
}

TEST_F(MapFile, ReadsByTheThresholds) {
  const CostMap map = read(kYaml, kPgm);
  // 0xFE free, 0xCD unknown; 0x59 = 89: 166 / 255 = 0.6510 occupied; 0x5A = 90: 0.6471 unknown.
  EXPECT_EQ(states(map, 3, 2), "fouofu");
  EXPECT_EQ(map.resolution_m, 0.05);
  EXPECT_EQ(map.origin_x_m, -1.5);
  EXPECT_EQ(map.origin_y_m, 2.25);
}

TEST_F(MapFile, ReadsNegatedTextAndDeepPictures) {
  std::string negated = kYaml;
  negated.replace(negated.find("negate: 0"), 9, "negate: 1");
  EXPECT_EQ(states(read(negated, "P5 2 1 255 \xff" + std::string(1, '\0')), 2, 1), "of");
  EXPECT_EQ(states(read(kYaml, "P2 # a comment\n# another\n3 1\n15 0 15 # mid\n 12"), 3, 1), "ofu");
  const std::string deep = std::string("P5 3 1 65535\n") + '\xff' + '\xff' + '\0' + '\x01' + '\xcd' + '\xcd';
  EXPECT_EQ(states(read(kYaml, deep), 3, 1), "fou");
  EXPECT_EQ(states(read(kYaml + "mode: trinary\n", "P5 1 1 255\n\xff"), 1, 1), "f");
}

TEST_F(MapFile, WrittenAndReadIsTheSameMap) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const CostMap map = random_map(seed);
    write_map(map, path("costmap.yaml"));
    const CostMap again = read_map(path("costmap.yaml"));
    const CellRectangle part = *bounds(map);
    ASSERT_EQ(again.resolution_m, map.resolution_m);
    ASSERT_EQ(again.origin_x_m, map.origin_x_m + part.low.x * map.resolution_m);
    ASSERT_EQ(again.origin_y_m, map.origin_y_m + part.low.y * map.resolution_m);
    for (std::int32_t y = -2; y < part.height() + 2; ++y) {
      for (std::int32_t x = -2; x < part.width() + 2; ++x) {
        ASSERT_EQ(again.state({x, y}), map.state({part.low.x + x, part.low.y + y}));
      }
    }
    const std::string yaml = get("costmap.yaml"), pgm = get("costmap.pgm");
    write_map(again, path("costmap.yaml"));
    ASSERT_EQ(get("costmap.yaml"), yaml);
    ASSERT_EQ(get("costmap.pgm"), pgm);
  }
}

TEST_F(MapFile, WritesMapServersGreys) {
  CostMap map{0.25, 10, 20, {}};
  map.set_state({-3, 5}, CellState::free);
  map.set_state({-2, 6}, CellState::occupied);
  write_map(map, path("costmap.yaml"));
  EXPECT_EQ(get("costmap.pgm"), std::string("P5\n2 2\n255\n\xcd\x00\xfe\xcd", 15));
  EXPECT_EQ(get("costmap.yaml"),
            "image: costmap.pgm\nmode: trinary\nresolution: 0.25\norigin: [9.25, 21.25, 0]\nnegate: 0\n"
            "occupied_thresh: 0.65\nfree_thresh: 0.196\n");
}

TEST_F(MapFile, AnUnknownMapIsOneUnknownPixel) {
  write_map(CostMap{}, path("costmap.yaml"));
  EXPECT_FALSE(bounds(read_map(path("costmap.yaml"))));
}

TEST_F(MapFile, NumbersDoNotDependOnTheLocale) {
  write_map(random_map(1), path("a.yaml"));
  const char* german = std::setlocale(LC_ALL, "de_DE.UTF-8");
  if (german == nullptr) german = std::setlocale(LC_ALL, "de_DE");
  if (german == nullptr) GTEST_SKIP() << "no locale with a decimal comma is installed";
  write_map(random_map(1), path("b.yaml"));
  std::setlocale(LC_ALL, "C");
  EXPECT_EQ(get("a.yaml").substr(13), get("b.yaml").substr(13));
}

struct Fault {
  std::string was, becomes, message;
};

TEST_F(MapFile, FaultsInTheYamlAreOneClearLine) {
  const std::vector<Fault> faults = {
      {"image: m.pgm\n", "", "key image is missing"},
      {"resolution: 0.05\n", "", "key resolution is missing"},
      {"origin: [-1.5, 2.25, 0.0]\n", "", "key origin is missing"},
      {"0.05", "0", "resolution (line 2) must be a number from 0.0001 to 1000"},
      {"0.05", "five", "not 'five'"},
      {"2.25, 0.0]", "2.25, 0.1]", "yaw that is not 0"},
      {"2.25, 0.0]", "2.25]", "origin (line 3) must be a list of 3 numbers"},
      {"negate: 0", "negate: 2", "negate (line 4) must be 0 or 1"},
      {"0.65", "1.5", "occupied_thresh"},
      {"0.65", "0.1", "free_thresh must be smaller"},
      {"negate: 0", "mode: scale", "mode (line 4) must be trinary, not 'scale'"},
      {"negate: 0", "mode: raw", "mode (line 4) must be trinary, not 'raw'"},
      {"image: m.pgm", "image: [", "YAML"},
      {"m.pgm", "other.pgm", "other.pgm"},
      {"free_thresh", "free_tresh", "unknown key free_tresh (line 6): did you mean free_thresh?"},
      {"negate: 0", "Negate: 0", "did you mean negate?"},
      {"image: m.pgm", "image: m.pgm\nimage: m.pgm", "image (line 2) stands twice"},
      {"image: m.pgm", "image: \xff", "UTF-8"},
  };
  for (const Fault& fault : faults) {
    std::string yaml = kYaml;
    yaml.replace(yaml.find(fault.was), fault.was.size(), fault.becomes);
    const std::string error = error_of(yaml, kPgm);
    EXPECT_THAT(error, HasSubstr(fault.message)) << yaml;
    EXPECT_EQ(error.find('\n'), error.npos);
  }
}

TEST_F(MapFile, KeysOfOtherProgramsAreLeftAside) {
  EXPECT_EQ(error_of(std::string(kYaml) + "author: somebody\nrobot_radius_px: 3\n", kPgm), "no error");
}

TEST_F(MapFile, FaultsInThePictureAreOneClearLine) {
  const std::vector<std::pair<std::string, std::string>> faults = {
      {"", "is no grey PGM"},
      {"P6\n1 1\n255\nabc", "is no grey PGM"},
      {"P5", "has no width"},
      {"P5 3", "has no height"},
      {"P5 3 2", "has no brightest grey"},
      {"P5 3 2 0\n", "has no brightest grey from 1 to 65535"},
      {"P5 3 2 65536\n", "has no brightest grey"},
      {"P5 -3 2 255\n", "has no width"},
      {"P5 0 2 255\n", "has no width"},
      {"P5 100000 100000 255\nabc", "is cut: 10000000000 bytes of picture announced, 3 there"},
      {"P5 99999999999999 1 255\n", "has no width"},
      {"P5 3 2 255\nabcde", "is cut: 6 bytes of picture announced, 5 there"},
      {"P5 3 2 255", "is cut"},
      {"P5 1 1 100\n\xff", "brighter than its brightest grey"},
      {"P2 3 2 255\n1 2 3 4 5", "is cut"},
      {"P2 3 2 255\n1 2 3 4 5 # nothing more", "has no grey"},
      {"P2 1 1 255\n256", "has no grey from 0 to 255"},
      {"P2 1 1 255\nxx", "has no grey"},
  };
  for (const auto& [pgm, message] : faults) {
    const std::string error = error_of(kYaml, pgm);
    EXPECT_THAT(error, HasSubstr(message)) << pgm;
    EXPECT_THAT(error, HasSubstr("m.pgm: "));
  }
}

TEST_F(MapFile, HostileBytesAreReadOrRefused) {
  Random random(5);
  for (int round = 0; round < 1000; ++round) {
    std::string yaml = kYaml, pgm = random.below(2) == 0 ? kPgm : "P2\n3 2\n255\n0 254 205 255 89 90\n";
    std::string& text = random.below(2) == 0 ? yaml : pgm;
    for (auto changes = 1 + random.below(3); changes > 0; --changes) {
      text[random.below(text.size())] = static_cast<char>(random.below(256));
      if (random.below(4) == 0) text.resize(1 + random.below(text.size()));
    }
    const std::string error = error_of(yaml, pgm);
    ASSERT_TRUE(std::ranges::none_of(error, [](char c) { return static_cast<unsigned char>(c) < 0x20; })) << error;
  }
}

TEST_F(MapFile, AFolderThatCannotBeWrittenLeavesNothing) {
  EXPECT_THROW(write_map(random_map(2), path("missing/costmap.yaml")), InputError);
  EXPECT_TRUE(fs::is_empty(folder_));
}

TEST_F(MapFile, RecordedMapsAgreeWithTheirPixels) {
  const std::string folder = std::string(SCANWAY_SHARED_DIR) + "/data/occupancy_maps/";
  if (!fs::exists(folder)) GTEST_SKIP() << folder << " is not there";
  for (const auto& [name, free_threshold] : {std::pair{"depot", 0.25}, std::pair{"warehouse", 0.1}}) {
    const CostMap map = read_map(folder + name + ".yaml");
    std::ifstream in(folder + name + ".pgm", std::ios::binary);
    std::string magic, line;
    int width = 0, height = 0, brightest = 0;
    std::getline(in, magic);
    while (in.peek() == '#') std::getline(in, line);
    in >> width >> height >> brightest;
    in.get();
    ASSERT_EQ(brightest, 255);
    for (int row = 0; row < height; ++row) {
      for (int x = 0; x < width; ++x) {
        const double occupancy = (255 - in.get()) / 255.0;
        const CellState expected = occupancy >= 0.65             ? CellState::occupied
                                   : occupancy <= free_threshold ? CellState::free
                                                                 : CellState::unknown;
        ASSERT_EQ(map.state({x, height - 1 - row}), expected) << name << " " << x << " " << row;
      }
    }
  }
}

}  // namespace
}  // namespace scanway
