#include "common/config/robot_file.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <regex>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/config/footprint.h"
#include "common/config/robot_fields.h"
#include "common/files/input_error.h"
#include "common/random/random.h"

namespace scanway {
namespace {

using testing::HasSubstr;

/// Draws every value anew, within its range.
class Dice : public Fields {
 public:
  explicit Dice(std::uint64_t seed) : random_(seed) {}
  void begin_section(std::string_view) override {}
  void end_section() override {}
  void number(std::string_view key, double& value, Range range) override {
    // Any double will do, not only those near to a number in degrees: a few units in the last place beside it as well.
    const double scale = key.find("_deg") != key.npos ? M_PI / 180 : key.ends_with("_mrad") ? 1e-3 : 1;
    value = (range.lowest + (range.highest - range.lowest) * (0.01 + 0.98 * random_.uniform())) * scale;
    for (auto steps = random_.below(5); steps > 0; --steps) value = std::nextafter(value, 0.0);
  }
  void whole_number(std::string_view, int& value, Range range) override {
    value = static_cast<int>(range.lowest) + static_cast<int>(random_.below(1000));
  }
  void boolean(std::string_view, bool& value) override { value = random_.below(2) == 1; }
  void text(std::string_view, std::string& value) override {
    const std::vector<std::string> names = {"x", "it's \"quoted\" \\ : # [", "Jürgen", "~", "null", " 12 ", "true"};
    value = names[random_.below(names.size())];
  }
  void numbers(std::string_view key, std::span<double> values, Range range) override {
    for (double& value : values) number(key, value, range);
  }
  void points(std::string_view, std::vector<Eigen::Vector2d>& points, PointsCheck) override {
    points.clear();
    const auto corners = 3 + random_.below(9);
    for (std::uint64_t i = 0; i < corners; ++i) {
      const double angle = 2 * M_PI * (static_cast<double>(i) + 0.4 * random_.uniform()) / static_cast<double>(corners);
      const double radius = 0.1 + 5 * random_.uniform();
      points.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    }
    if (corners == 3) points = {{0.5, 0.1}, {-0.5, 0.3}, {-0.0, -1.0 / 3}};
  }
  void choice(std::string_view, int& index, std::span<const std::string_view> names) override {
    index = static_cast<int>(random_.below(names.size()));
  }

 private:
  Random random_;
};

/// All keys, dotted.
class KeyList : public Fields {
 public:
  std::vector<std::string> keys;
  void begin_section(std::string_view name) override { prefix_ += std::string(name) + "."; }
  void end_section() override { prefix_.erase(prefix_.substr(0, prefix_.size() - 1).rfind('.') + 1); }
  void number(std::string_view key, double&, Range) override { add(key); }
  void whole_number(std::string_view key, int&, Range) override { add(key); }
  void boolean(std::string_view key, bool&) override { add(key); }
  void text(std::string_view key, std::string&) override { add(key); }
  void numbers(std::string_view key, std::span<double>, Range) override { add(key); }
  void points(std::string_view key, std::vector<Eigen::Vector2d>&, PointsCheck) override { add(key); }
  void choice(std::string_view key, int&, std::span<const std::string_view>) override { add(key); }

 private:
  void add(std::string_view key) { keys.push_back(prefix_ + std::string(key)); }
  std::string prefix_;
};

std::string error_of(std::string_view text) {
  try {
    parse_robot(text, "robot.yaml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

std::string text_of_file(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(RobotFile, TheShippedOneIsTheDefault) {
  const Robot shipped = load_robot(SCANWAY_SOURCE_DIR "/launch/robots/era_mobi.yaml");
  EXPECT_TRUE(shipped == Robot{});
  EXPECT_EQ(robot_text(shipped), robot_text(Robot{}));
  EXPECT_DOUBLE_EQ(shipped.tracker.heading_sigma, 5 * M_PI / 180);
  EXPECT_DOUBLE_EQ(shipped.circumscribed_radius_m(), std::hypot(0.2, 0.205));
  EXPECT_DOUBLE_EQ(shipped.inscribed_radius_m(), 0.2);
}

TEST(RobotFile, AMissingKeyKeepsItsDefault) {
  Robot expected;
  expected.body.height_m = 0.75;
  EXPECT_TRUE(parse_robot("body:\n  height_m: 0.75\n", "x") == expected);
  EXPECT_TRUE(parse_robot("", "x") == Robot{});
  EXPECT_TRUE(parse_robot("# nothing\nschema: 1\nbody:\n", "x") == Robot{});
}

TEST(RobotFile, WrittenAndReadIsTheSameToTheLastBit) {
  for (std::uint64_t seed = 0; seed < 3000; ++seed) {
    Dice dice(seed);
    Robot robot;
    describe(dice, robot);
    robot.laser.min_range_m = 0.5 * robot.laser.max_range_m * 1e-3;
    robot.body.climbable_step_m = std::min(2.0, robot.body.height_m / 3);
    if (!footprint_problem(robot.body.footprint).empty()) robot.body.footprint = Robot{}.body.footprint;
    const std::string text = robot_text(robot);
    const Robot again = parse_robot(text, "again");
    ASSERT_TRUE(again == robot) << text;
    ASSERT_EQ(robot_text(again), text);
  }
}

TEST(RobotFile, WholeDegreesAreWrittenAsSuch) {
  Robot robot;
  for (int degrees = 1; degrees <= 60; ++degrees) {
    robot.body.climbable_slope = radians(degrees);
    EXPECT_THAT(robot_text(robot), HasSubstr("climbable_slope_deg: " + std::to_string(degrees) + "\n"));
  }
}

TEST(RobotFile, EveryKeyIsInTheDocs) {
  const std::string docs = text_of_file(SCANWAY_SOURCE_DIR "/docs/robot-file.md");
  KeyList list;
  Robot robot;
  describe(list, robot);
  ASSERT_GT(list.keys.size(), 30u);
  for (const std::string& key : list.keys) EXPECT_THAT(docs, HasSubstr("\n| `" + key + "` |"));
  const std::regex row("\n\\| `([^`]+)` \\|");
  for (auto match = std::sregex_iterator(docs.begin(), docs.end(), row); match != std::sregex_iterator(); ++match) {
    const std::string key = (*match)[1];
    EXPECT_TRUE(key == "schema" || std::ranges::count(list.keys, key) == 1) << key << " is in the docs only";
  }
}

struct Fault {
  const char* text;
  const char* message;
};

class RobotFileFault : public testing::TestWithParam<Fault> {};

TEST_P(RobotFileFault, IsOneClearLine) {
  const std::string error = error_of(GetParam().text);
  EXPECT_THAT(error, HasSubstr(GetParam().message));
  EXPECT_THAT(error, testing::StartsWith("robot.yaml: "));
  EXPECT_EQ(error.find('\n'), error.npos);
}

INSTANTIATE_TEST_SUITE_P(
    All, RobotFileFault,
    testing::Values(
        Fault{"schema: 1\n\n\nname: a\nbody:\n  # x\n  hight_m: 1\n",
              "unknown key body.hight_m (line 7): did you mean body.height_m?"},
        Fault{"body: {height_cm: 150}",
              "unknown key body.height_cm (line 1): it is given in metres: write body.height_m"},
        Fault{"tracker: {heading_sigma_rad: 0.1}", "in degrees: write tracker.heading_sigma_deg"},
        Fault{"body: {height: 1.5}", "in metres: write body.height_m"},
        Fault{"height_m: 1", "unknown key height_m (line 1): did you mean body.height_m?"},
        Fault{"bodi: {height_m: 1}", "unknown key bodi (line 1): did you mean body?"},
        Fault{"mounts: {pan_lazer: {position_m: [0, 0, 0]}}", "did you mean mounts.pan_laser?"},
        Fault{"warp_drive: 9", "unknown key warp_drive (line 1): remove it"},
        Fault{"\"a\\x1b[2J\\n\": 1", "unknown key a\\x1B[2J\\n (line 1)"},
        Fault{"body: {height_m: tall}", "body.height_m (line 1) must be a number from 0.01 to 100 metres, not 'tall'"},
        Fault{"body: {height_m: 1.5m}", "not '1.5m'"}, Fault{"body: {height_m: 0x1p3}", "must be a number"},
        Fault{"body: {height_m: nan}", "must be a number"}, Fault{"body: {height_m: 1e999}", "must be a number"},
        Fault{"body: {height_m: '1,5'}", "must be a number"}, Fault{"body: {height_m: }", "not empty"},
        Fault{"body: {height_m: [1]}", "not a list"}, Fault{"body: {height_m: {a: 1}}", "not a section"},
        Fault{"body: {height_m: 200}", "from 0.01 to 100 metres, not '200'"}, Fault{"body: {height_m: -1}", "not '-1'"},
        Fault{"body: 7", "body (line 1) must be a section"},
        Fault{"body: {climbable_slope_deg: 61}", "from 0 to 60 degrees"},
        Fault{"laser: {beams: 2.5}", "laser.beams (line 1) must be a whole number from 2 to 100000, not '2.5'"},
        Fault{"mapping: {octomap_discretize: maybe}", "must be true or false, not 'maybe'"},
        Fault{"mapping: {embodiment: ghost}", "must be footprint or paper, not 'ghost'"},
        Fault{"mapping: {vegetation: eat}", "must be ignore or pass or avoid, not 'eat'"},
        Fault{"planning:\n  unknown: sometimes", "planning.unknown (line 2) must be never or price or free"},
        Fault{"mounts: {base_mount: {position_m: [1, 2]}}", "must be a list of 3 numbers"},
        Fault{"body:\n  height_m: 1\n  height_m: 2", "body.height_m (line 3) stands twice"},
        Fault{"name: a\nname: b", "name (line 2) stands twice"}, Fault{"name: [a]", "must be 1 to 255"},
        Fault{"laser: {min_range_m: 5, max_range_m: 4}", "laser.min_range_m must be smaller than laser.max_range_m"},
        Fault{"schema: 2", "schema (line 1) is newer than this program knows (1): update Scanway"},
        Fault{"schema: one", "schema (line 1) must be 1"}, Fault{"schema: 0", "schema (line 1) must be 1"},
        Fault{"body: {footprint_m: [[1, 1], [-1, 1]]}", "body.footprint_m (line 1) has fewer than 3 corners"},
        Fault{"body: {footprint_m: [[1, 1], [-1, -1], [-1, 1], [1, -1]]}", "crosses or touches itself"},
        Fault{"body: {footprint_m: [[1, 1], [1, -1], [-1, -1], [-1, 1]]}", "runs clockwise"},
        Fault{"body: {footprint_m: [[3, 1], [2, 1], [2, -1], [3, -1]]}", "does not have the robot's centre"},
        Fault{"body: {footprint_m: [[1, 1], [0, 1], [0, -1], [1, -1]]}", "does not have the robot's centre"},
        Fault{"body: {footprint_m: [[1, 1], [1, 1], [-1, 1], [0, -1]]}", "same corner twice"},
        Fault{"body: {footprint_m: [[1, 1], [-1, 1], -1]}", "must be a list of corners"},
        Fault{"body: {footprint_m: [[1, 1], [-1, 1], [0, -1, 2]]}", "must be a list of corners"},
        Fault{"body: {footprint_m: [[1, 1], [-1, 1], [0, low]]}", "not 'low'"}, Fault{"body: [", "is not valid YAML"},
        Fault{"a: b: c", "is not valid YAML (line 1)"}, Fault{"*nowhere", "YAML"},
        Fault{"- 1\n- 2", "is no list of `key: value` lines"}, Fault{"just text", "is no list of `key: value` lines"},
        Fault{"name: a\n---\nname: b", "more than one YAML document"},
        Fault{"name: \xff\xfe", "is no text in UTF-8 (line 1)"},
        Fault{"a: 1\nname: \xc3", "is no text in UTF-8 (line 2)"}, Fault{"name: \x1b[31m", "is no text in UTF-8"},
        Fault{"[a, b]: 1", "no word"}, Fault{"<<: {body: 1}", "unknown key"}));

TEST(RobotFile, HostileTextNeverEscapes) {
  const std::string good = robot_text(Robot{});
  Random random(7);
  for (int round = 0; round < 3000; ++round) {
    std::string text = good;
    for (auto changes = 1 + random.below(4); changes > 0; --changes) {
      const auto at = random.below(text.size());
      if (random.below(3) == 0)
        text.erase(at, random.below(40));
      else
        text[at] = static_cast<char>(random.below(256));
    }
    const std::string error = error_of(text);
    ASSERT_TRUE(std::ranges::none_of(error, [](char c) { return static_cast<unsigned char>(c) < 0x20; })) << error;
  }
  EXPECT_THAT(error_of(std::string(100000, '[')), HasSubstr("YAML"));
  EXPECT_THAT(error_of(std::string(2 << 20, '#')), HasSubstr("longer than 1 MiB"));
  EXPECT_THAT(error_of(std::string("name: a\0b", 9)), HasSubstr("is no text in UTF-8"));
}

TEST(RobotFile, AFileThatIsNotThereIsOneLine) { EXPECT_THROW(load_robot("/nowhere/robot.yaml"), InputError); }

}  // namespace
}  // namespace scanway
