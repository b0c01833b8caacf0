#include "modules/tools/decode/decode_xsens.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>

#include <nlohmann/json.hpp>

#include "tests/support/command.h"

namespace scanway {
namespace {

using Json = nlohmann::json;

const std::string kFacts = SCANWAY_SHARED_DIR "/facts/xsens/";

#define SKIP_WITHOUT_FACTS() \
  if (!std::filesystem::exists(kFacts)) GTEST_SKIP() << "the recorded messages are not at " << kFacts

std::vector<Json> decode(std::span<const std::uint8_t> bytes) {
  std::ostringstream out;
  tools::decode_xsens(bytes, out);
  std::vector<Json> lines;
  std::istringstream in(out.str());
  for (std::string line; std::getline(in, line);) lines.push_back(Json::parse(line));
  return lines;
}

std::vector<std::uint8_t> bytes_of(const std::string& hex) {
  std::vector<std::uint8_t> bytes;
  std::istringstream in(hex);
  for (std::string word; in >> word;) bytes.push_back(static_cast<std::uint8_t>(std::stoi(word, nullptr, 16)));
  return bytes;
}

Json rows_of(const Json& columns) {
  Json rows = Json::array();
  for (int i = 0; i < 9; ++i) rows.push_back(columns[(i % 3) * 3 + i / 3]);
  return rows;
}

void expect_named(const Json& line, const std::string& name, const Json& value) {
  if (name == "rotation_matrix_wire_order") {
    EXPECT_EQ(line["rotation_matrix"], rows_of(value));
  } else if (name == "unknown") {
    EXPECT_EQ(line["unknown"][0]["hex"], value);
  } else {
    EXPECT_EQ(line[name], value) << name;
  }
}

TEST(DecodeXsens, CapturesByTheirSideFiles) {
  SKIP_WITHOUT_FACTS();
  for (const char* name : {"mtig710-euler-float32", "mtig710-euler-fp1220", "mtig710-euler-float64"}) {
    const std::string bytes = test::read_text(kFacts + "captures/" + name + ".bin");
    const auto lines = decode(std::span(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()));
    const Json said = Json::parse(test::read_text(kFacts + "captures/" + name + ".json"))["messages"];
    ASSERT_EQ(lines.size(), said.size());
    for (std::size_t i = 0; i < lines.size(); ++i) {
      EXPECT_EQ(lines[i]["type"], "MTData2");
      for (const Json& item : said[i]["items"]) expect_named(lines[i], item["name"], item["value"]);
    }
  }
}

TEST(DecodeXsens, VectorsByWhatTheySay) {
  SKIP_WITHOUT_FACTS();
  const Json vectors = Json::parse(test::read_text(kFacts + "vectors.json"));
  for (const Json& vector : vectors["vectors"]) {
    const auto lines = decode(bytes_of(vector["hex"]));
    ASSERT_EQ(lines.size(), 1U) << vector["name"];
    ASSERT_NE(lines[0]["type"], "bad") << vector["name"];
    if (!vector.contains("decoded")) continue;
    const Json& said = vector["decoded"];
    for (const auto& entry : said.items()) {
      if (said.is_object()) expect_named(lines[0], entry.key(), entry.value());
      if (said.is_array() && entry.value().contains("name")) {
        expect_named(lines[0], entry.value()["name"], entry.value()["value"]);
      }
    }
  }
}

TEST(DecodeXsens, OlderMessagesFollowTheSetUpBeforeThem) {
  SKIP_WITHOUT_FACTS();
  const Json vectors = Json::parse(test::read_text(kFacts + "vectors.json"))["vectors"];
  std::vector<std::uint8_t> stream;
  for (const char* name : {"derived_SetOutputMode_orient_only_0004", "derived_SetOutputSettings_matrix_counter",
                           "derived_legacy_MTData_matrix_counter"}) {
    for (const Json& vector : vectors) {
      const auto bytes = bytes_of(vector["hex"]);
      if (vector["name"] == name) stream.insert(stream.end(), bytes.begin(), bytes.end());
    }
  }
  const auto lines = decode(stream);
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_EQ(lines[2]["layout_from"], "set-up");
  EXPECT_EQ(lines[2]["packet_counter"], 65535);
  EXPECT_EQ(decode(std::span(stream).subspan(16)).at(0)["layout_from"], "guess");
}

TEST(DecodeXsens, BrokenStretchesAreMarkedWhereTheyAre) {
  SKIP_WITHOUT_FACTS();
  const Json stream = Json::parse(test::read_text(kFacts + "vectors.json"))["streams"][0];
  const auto lines = decode(bytes_of(stream["hex"]));
  std::vector<std::uint64_t> bad_offsets;
  for (const Json& line : lines) {
    if (line["type"] == "bad") bad_offsets.push_back(line["offset"]);
  }
  EXPECT_EQ(bad_offsets, (std::vector<std::uint64_t>{0, 48, 93}));
  EXPECT_EQ(lines.size(), 3 + stream["expected_frames"].size());
}

}  // namespace
}  // namespace scanway
