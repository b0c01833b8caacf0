#include "modules/tools/decode/decode_erratic.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>

#include <nlohmann/json.hpp>

#include "tests/support/command.h"

namespace scanway {
namespace {

using Json = nlohmann::json;

std::vector<std::uint8_t> bytes_of(const std::string& hex) {
  std::vector<std::uint8_t> bytes;
  std::istringstream in(hex);
  for (std::string word; in >> word;) bytes.push_back(static_cast<std::uint8_t>(std::stoi(word, nullptr, 16)));
  return bytes;
}

std::vector<Json> decode(const std::vector<std::uint8_t>& bytes) {
  std::ostringstream out;
  tools::decode_erratic(bytes, out);
  std::vector<Json> lines;
  std::istringstream in(out.str());
  for (std::string line; std::getline(in, line);) lines.push_back(Json::parse(line));
  return lines;
}

Json vectors() {
  const std::string path = SCANWAY_SHARED_DIR "/facts/erratic/vectors.json";
  return std::filesystem::exists(path) ? Json::parse(test::read_text(path)) : Json();
}

/// The sheet's own words for a vector against the line's.
void expect_decoded(const Json& line, const Json& decoded, const std::string& name) {
  for (const auto& [key, value] : decoded.items()) {
    if (name == "config_reply_rev_h") {
      EXPECT_EQ(line[key == "type" ? "robot_type" : key], value);
    } else if (name == "sonar_two_channels") {
      EXPECT_EQ(line["ranges_m"][key], value);
    } else if (key == "type") {
      EXPECT_EQ(line["packet"], value);
    } else if (value.is_number_float()) {
      EXPECT_NEAR(line[key].get<double>(), value.get<double>(), 1e-9) << name << ' ' << key;
    } else {
      EXPECT_EQ(line[key], value) << name << ' ' << key;
    }
  }
}

TEST(DecodeErratic, GivesEveryVectorOfTheSheetItsMeaning) {
  const Json sheet = vectors();
  if (sheet.is_null()) GTEST_SKIP() << "the shared facts are not here";
  const Json commands = {{"configuration_request", "configuration"},
                         {"stop", "stop"},
                         {"save_config", "save_config"},
                         {"servo_2_position_1650", "servo_pos"},
                         {"pulse", "pulse"}};
  for (const Json& vector : sheet["vectors"]) {
    const std::string name = vector["name"];
    const std::vector<Json> lines = decode(bytes_of(vector["hex"]));
    ASSERT_EQ(lines.size(), 1u) << name;
    ASSERT_NE(lines[0]["type"], "bad") << name;
    EXPECT_EQ(lines[0].contains("direction"), vector["direction"] == "host to robot") << name;
    if (vector.contains("decoded")) expect_decoded(lines[0], vector["decoded"], name);
    if (commands.contains(name)) {
      EXPECT_EQ(lines[0]["type"], commands[name]);
    }
  }
}

TEST(DecodeErratic, ReadsSignsWheelsAndServos) {
  EXPECT_EQ(decode(bytes_of("FA FB 06 0B 1B C8 00 D3 1B"))[0]["value"], -200);
  EXPECT_EQ(decode(bytes_of("FA FB 06 15 3B 1E 00 33 3B"))[0]["value"], 30);
  const Json wheels = decode(bytes_of("FA FB 06 20 3B 0A F6 2B 31"))[0];
  EXPECT_EQ(wheels["left_mm_s"], -200);
  EXPECT_EQ(wheels["right_mm_s"], 200);
  const Json servo = decode(bytes_of("FA FB 08 4B 2B 03 02 72 06 C0 33"))[0];
  EXPECT_EQ(servo["servo"], 2);
  EXPECT_EQ(servo["counts"], 1650);
}

TEST(DecodeErratic, MarksWhatIsBroken) {
  const Json sheet = vectors();
  if (sheet.is_null()) GTEST_SKIP() << "the shared facts are not here";
  const std::vector<Json> lines = decode(bytes_of(sheet["streams"][0]["hex"]));
  std::uint64_t covered = 0, good = 0;
  for (const Json& line : lines) {
    if (line["type"] != "bad") {
      ++good;
      EXPECT_EQ(line["raw_x_12bit"], 100);
      EXPECT_EQ(line["left_raw"], 166);
      continue;
    }
    EXPECT_FALSE(line["reason"].get<std::string>().empty());
    covered += line["length"].get<std::uint64_t>();
  }
  EXPECT_EQ(good, 2u);
  EXPECT_EQ(covered, bytes_of(sheet["streams"][0]["hex"]).size() - 2 * 23);
  EXPECT_EQ(lines[0]["offset"], 0);
}

TEST(DecodeErratic, RejectsPayloadsThatContradictTheirType) {
  // A sonar packet that announces three ranges and holds none.
  const std::vector<Json> lines = decode({0xFA, 0xFB, 0x04, 0x9B, 0x03, 0x9B, 0x03});
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0]["type"], "bad");
}

}  // namespace
}  // namespace scanway
