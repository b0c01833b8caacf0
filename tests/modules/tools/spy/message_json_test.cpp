#include "modules/tools/spy/message_json.h"

#include <bit>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "bot_core/planar_lidar_t.hpp"
#include "common/messages/codec.h"
#include "scanway/health_t.hpp"
#include "scanway/path_t.hpp"
#include "tests/common/messages/random_wire.h"

namespace scanway::tools {
namespace {

using Bytes = std::vector<std::uint8_t>;
using Json = nlohmann::ordered_json;
using Kind = Layout::Kind;

Json json_of(const Bytes& message, std::size_t most = kAllElements) {
  return message_json(*find_layout(fingerprint(message)), message, most);
}

TEST(MessageJson, HoldsTheFieldsAsTheyWereSaid) {
  bot_core::planar_lidar_t scan{};
  scan.utime = INT64_MAX;
  scan.nranges = 3;
  scan.ranges = {0.1F, -2.5F, NAN};
  scan.nintensities = 0;
  scan.rad0 = -1.5F;
  scan.radstep = 0.0029F;
  const Json json = json_of(encode(scan));
  EXPECT_EQ(json["utime"], INT64_MAX);
  EXPECT_EQ(json["ranges"][0], 0.1);  // As the float is written.
  EXPECT_EQ(json["ranges"][1], -2.5);
  EXPECT_TRUE(std::isnan(json["ranges"][2].get<double>()));
  EXPECT_EQ(json["intensities"], Json::array());
  EXPECT_EQ(json["radstep"], 0.0029);
  EXPECT_EQ(json.begin().key(), "utime");
}

TEST(MessageJson, HoldsNestedTypesStringsAndTruthValues) {
  health_t health{};
  health.process_name = "a \"b\"\n\xC3\xA9";
  health.process_id = -7;
  health.ncounters = 2;
  health.counters.resize(2);
  health.counters[1].counter_name = "gaps";
  health.counters[1].count = -3;
  const Json json = json_of(encode(health));
  EXPECT_EQ(json["process_name"], health.process_name);
  EXPECT_EQ(json["process_id"], -7);
  EXPECT_EQ(json["counters"][1], (Json{{"counter_name", "gaps"}, {"count", -3}}));
  path_t path{};
  path.provisional = 1;
  EXPECT_EQ(json_of(encode(path))["provisional"], true);
  EXPECT_EQ(json_of(encode(path))["map_up_to_date"], false);
}

// Bytes of a message again, from its JSON: what is lost or mixed up on the way there shows.
class Writer {
 public:
  Bytes write(const Layout& layout, const Json& message) {
    put(static_cast<std::uint64_t>(layout.hash), 8);
    put_fields(layout, message);
    return bytes_;
  }

 private:
  void put(std::uint64_t value, int bytes) {
    for (int i = bytes - 1; i >= 0; --i) bytes_.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
  }
  void put_fields(const Layout& layout, const Json& fields) {
    for (const Layout::Member& member : layout.members) put_value(member, fields.at(member.name));
  }
  void put_value(const Layout::Member& member, const Json& value) {
    if (value.is_array()) {
      for (const Json& element : value) put_value(member, element);
    } else if (member.kind == Kind::nested) {
      put_fields(*member.nested, value);
    } else if (member.kind == Kind::string) {
      const auto text = value.get<std::string>();
      put(text.size() + 1, 4);
      bytes_.insert(bytes_.end(), text.begin(), text.end());
      bytes_.push_back(0);
    } else if (member.kind == Kind::float32) {
      put(std::bit_cast<std::uint32_t>(value.get<float>()), 4);
    } else if (member.kind == Kind::float64) {
      put(std::bit_cast<std::uint64_t>(value.get<double>()), 8);
    } else if (value.is_boolean()) {
      put(value.get<bool>() ? 1 : 0, 1);
    } else {
      const int widths[] = {1, 2, 4, 8};
      put(static_cast<std::uint64_t>(value.get<std::int64_t>()), widths[static_cast<int>(member.kind)]);
    }
  }

  Bytes bytes_;
};

bool holds_nan(const Json& value) {
  if (value.is_number_float()) return std::isnan(value.get<double>());
  return value.is_structured() && std::any_of(value.begin(), value.end(), holds_nan);
}
bool has_boolean(const Layout& layout) {
  return std::any_of(layout.members.begin(), layout.members.end(),
                     [](const Layout::Member& member) { return member.type == "boolean"; });
}

TEST(MessageJson, LosesNothingOfAnyType) {
  Random random(11);
  int compared = 0;
  for (const Layout& layout : layouts()) {
    for (int i = 0; i < 40; ++i) {
      const Bytes wire = test::random_wire(layout, random, 4);
      ASSERT_EQ(find_fault(layout, wire), "");
      const Json json = message_json(layout, wire);
      // A NaN has many bits, and a boolean byte may be 17.
      if (holds_nan(json) || has_boolean(layout)) continue;
      EXPECT_EQ(Writer().write(layout, json), wire) << layout.name << json;
      ++compared;
    }
  }
  EXPECT_GT(compared, 500);
}

TEST(MessageText, ShowsTheFirstOfManyAndSaysHowManyMore) {
  bot_core::planar_lidar_t scan{};
  scan.nranges = 1141;
  scan.ranges.assign(1141, 2.0F);
  const std::string text = message_text(json_of(encode(scan), 2));
  EXPECT_NE(text.find("ranges        [2, 2, ... 1139 more]\n"), std::string::npos) << text;
  health_t health{};
  health.summary = "bell \a";
  health.ncounters = 3;
  health.counters.resize(3);
  const std::string nested = message_text(json_of(encode(health), 1));
  EXPECT_NE(nested.find("counter_name \"\", count 0\n    ... 2 more\n"), std::string::npos) << nested;
  EXPECT_NE(nested.find("\"bell \\x07\""), std::string::npos) << nested;
}

}  // namespace
}  // namespace scanway::tools
