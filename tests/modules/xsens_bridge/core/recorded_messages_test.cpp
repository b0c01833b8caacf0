#include <cstdio>

#include "modules/xsens_bridge/core/mtdata.h"
#include "modules/xsens_bridge/core/mtdata2.h"
#include "modules/xsens_bridge/core/reading.h"
#include "modules/xsens_bridge/core/replies.h"
#include "tests/modules/xsens_bridge/shared_xsens.h"

namespace scanway::test {
namespace {

using nlohmann::json;
using xsens::Item;

std::string hex_of(const std::vector<std::uint8_t>& bytes) {
  std::string text;
  for (const auto byte : bytes) {
    char digits[3];
    std::snprintf(digits, sizeof digits, "%02x", byte);
    text += digits;
  }
  return text;
}

std::string printed(const char* format, int digits, unsigned value) {
  char text[16];
  std::snprintf(text, sizeof text, format, digits, value);
  return text;
}

/// Rows of a matrix from the order in which the wire has them, which the side files keep.
json rows_of(const json& columns) {
  json rows = json::array();
  for (int i = 0; i < 9; ++i) rows.push_back(columns[(i % 3) * 3 + i / 3]);
  return rows;
}

/// The value as the side files write it.
json value_of(const Item& item) {
  if (const auto* numbers = std::get_if<xsens::Numbers>(&item.value)) {
    return numbers->size() == 1 ? json((*numbers)[0]) : json(*numbers);
  }
  if (const auto* integer = std::get_if<std::uint32_t>(&item.value)) return *integer;
  if (const auto* field = std::get_if<xsens::BitField>(&item.value))
    return printed("0x%0*X", field->digits, field->bits);
  if (const auto* utc = std::get_if<xsens::UtcTime>(&item.value)) {
    return {{"ns", utc->nanosecond}, {"year", utc->year},
            {"month", utc->month},   {"day", utc->day},
            {"hour", utc->hour},     {"minute", utc->minute},
            {"second", utc->second}, {"flags", printed("0x%0*X", 2, utc->flags)}};
  }
  return hex_of(std::get<xsens::Bytes>(item.value));
}

void expect_items(const std::vector<Item>& items, const json& said) {
  ASSERT_EQ(items.size(), said.size());
  for (std::size_t i = 0; i < items.size(); ++i) {
    EXPECT_EQ(printed("0x%0*X", 4, items[i].id), said[i]["id"]);
    const bool matrix = said[i]["name"] == "rotation_matrix_wire_order";
    EXPECT_EQ(items[i].name, matrix ? "rotation_matrix" : said[i]["name"].get<std::string>());
    EXPECT_EQ(value_of(items[i]), matrix ? rows_of(said[i]["value"]) : said[i]["value"]) << said[i]["name"];
    if (said[i].contains("precision")) {
      EXPECT_EQ(name_of(items[i].format), said[i]["precision"]);
    }
    if (said[i].contains("frame")) {
      EXPECT_EQ(name_of(items[i].frame), said[i]["frame"]);
    }
  }
}

class Capture : public testing::TestWithParam<const char*> {};

TEST_P(Capture, DecodesToItsSideFile) {
  SKIP_WITHOUT_XSENS_FACTS();
  const std::string name = std::string("captures/") + GetParam();
  const json said = xsens_json(name + ".json")["messages"];
  const std::string bytes = read_text(kXsensFacts + name + ".bin");
  FrameFinder finder = xsens::make_frame_finder();
  // In pieces, as a serial line delivers them.
  std::size_t found = 0;
  for (std::size_t at = 0; at < bytes.size(); at += 61) {
    const std::string piece = bytes.substr(at, 61);
    finder.push(std::span(reinterpret_cast<const std::uint8_t*>(piece.data()), piece.size()));
    while (const auto stretch = finder.next()) {
      ASSERT_TRUE(stretch->whole);
      ASSERT_LT(found, said.size());
      EXPECT_EQ(stretch->offset, said[found]["offset"]);
      const auto message = xsens::open_frame(stretch->bytes);
      EXPECT_EQ(message.data.size(), said[found]["len"]);
      expect_items(xsens::parse_mtdata2(message.data), said[found]["items"]);
      ++found;
    }
  }
  EXPECT_EQ(found, said.size());
}

INSTANTIATE_TEST_SUITE_P(All, Capture,
                         testing::Values("mtig710-euler-float32", "mtig710-euler-fp1220", "mtig710-euler-float64"));

TEST(Vectors, EveryMessageIsReadAndMadeToTheByte) {
  SKIP_WITHOUT_XSENS_FACTS();
  for (const json& vector : xsens_vectors()) {
    const auto frame = bytes_of_spaced_hex(vector["hex"]);
    const auto probe = xsens::probe_frame(frame);
    ASSERT_EQ(probe.kind, FrameProbe::Kind::whole) << vector["name"];
    ASSERT_EQ(probe.length, frame.size()) << vector["name"];
    const auto message = xsens::open_frame(frame);
    EXPECT_EQ(printed("0x%0*X", 2, message.mid), vector["mid"]);
    EXPECT_EQ(message.data.size(), vector["payload_len"]);
    EXPECT_EQ(xsens::make_frame(message.mid, message.data), frame) << vector["name"];
    if (message.mid == xsens::kMtData2) expect_items(xsens::parse_mtdata2(message.data), vector["decoded"]);
  }
}

TEST(Vectors, OlderTrackersMessagesByTheirOutputMode) {
  SKIP_WITHOUT_XSENS_FACTS();
  int messages = 0;
  for (const json& vector : xsens_vectors()) {
    if (vector["mid"] != "0x32") continue;
    ++messages;
    const json& said = vector["decoded"];
    const auto data = xsens::open_frame(bytes_of_spaced_hex(vector["hex"])).data;
    const xsens::OutputLayout layout{
        static_cast<std::uint16_t>(std::stoul(said["output_mode"].get<std::string>(), nullptr, 16)),
        static_cast<std::uint32_t>(std::stoul(said["output_settings"].get<std::string>(), nullptr, 16))};
    EXPECT_EQ(length_of(layout), data.size());
    EXPECT_EQ(xsens::guess_layout(data), layout) << vector["name"];
    std::size_t compared = 2;
    for (const Item& item : xsens::parse_mtdata(data, layout)) {
      const bool matrix = item.name == "rotation_matrix";
      const std::string key = matrix ? "rotation_matrix_wire_order" : std::string(item.name);
      ASSERT_TRUE(said.contains(key)) << key;
      EXPECT_EQ(value_of(item), matrix ? rows_of(said[key]) : said[key]);
      ++compared;
    }
    EXPECT_EQ(compared, said.size());
  }
  EXPECT_EQ(messages, 5);
}

TEST(Vectors, AMessageOfAnotherLengthThanItsModeIsRefused) {
  EXPECT_THROW(xsens::parse_mtdata(std::vector<std::uint8_t>(17), {}), xsens::BadMessage);
  EXPECT_EQ(xsens::length_of({}), 18U);  // The factory's: quaternion and counter.
}

TEST(Vectors, Answers) {
  SKIP_WITHOUT_XSENS_FACTS();
  const auto legacy = parse_configuration(xsens_message("mti300_Configuration"));
  EXPECT_EQ(legacy.master_id, 0x037003F8U);
  EXPECT_EQ(legacy.period, 1152);
  EXPECT_EQ(legacy.num_devices, 1);
  EXPECT_EQ(legacy.device_id, 0x037003F8U);
  EXPECT_EQ(legacy.layout, (xsens::OutputLayout{0, 1}));
  EXPECT_EQ(parse_configuration(xsens_message("mti30_Configuration")).device_id, 0x0368248CU);
  EXPECT_EQ(parse_device_id(xsens_message("mti30_DeviceID")), 0x0368248CU);
  EXPECT_EQ(parse_product_code(xsens_message("mti30_ProductCode")), "MTi-30-2A8G4");
  const auto firmware = parse_firmware(xsens_message("mti300_FirmwareRev"));
  EXPECT_EQ(firmware.major, 1);
  EXPECT_EQ(firmware.minor, 8);
  EXPECT_EQ(firmware.revision, 2);
  EXPECT_EQ(firmware.build, 37U);
  EXPECT_EQ(firmware.svn_revision, 70964U);
  EXPECT_EQ(parse_output_configuration(xsens_message("mti300_OutputConfiguration")),
            (std::vector<xsens::OutputEntry>{{0x1020, 0xFFFF}, {0x1060, 0xFFFF}}));
  for (const char* name : {"legacy_mtig_Error_unsupported", "derived_Error_period_invalid",
                           "derived_Error_timer_overflow", "derived_Error_baudrate_invalid"}) {
    EXPECT_EQ(parse_error(xsens_message(name)), xsens_vector(name)["decoded"]["error_code"]);
  }
  EXPECT_EQ(xsens::error_name(33), "parameter invalid");
  EXPECT_EQ(xsens::message_name(0x36), "MTData2");
}

TEST(Vectors, RequestsAreMadeToTheByte) {
  SKIP_WITHOUT_XSENS_FACTS();
  const auto hex = [](const char* name) { return bytes_of_spaced_hex(xsens_vector(name)["hex"]); };
  EXPECT_EQ(xsens::set_number(xsens::kSetPeriod, 1152, 2), hex("derived_SetPeriod_1152_100Hz"));
  EXPECT_EQ(xsens::set_number(xsens::kSetOutputMode, 6, 2), hex("derived_SetOutputMode_calib_orient_0006"));
  EXPECT_EQ(xsens::set_number(xsens::kSetOutputSettings, 1, 4), hex("derived_SetOutputSettings_quat_counter"));
  EXPECT_EQ(xsens::set_number(xsens::kSetOutputSkipFactor, 0, 2), hex("derived_SetOutputSkipFactor_0"));
  EXPECT_EQ(xsens::set_number(xsens::kSetBaudrate, 0x80, 1), hex("vendor_SetBaudrate_921600"));
  EXPECT_EQ(xsens::set_output_configuration({{0x1020, 0xFFFF},
                                             {0x1060, 0xFFFF},
                                             {0x2010, 100},
                                             {0x2030, 100},
                                             {0x4020, 100},
                                             {0x8020, 100},
                                             {0xE020, 0xFFFF}}),
            hex("derived_SetOutputConfiguration_quat_euler_counter_time_status_100Hz"));
}

TEST(Vectors, ResynchronisationStream) {
  SKIP_WITHOUT_XSENS_FACTS();
  const json stream = xsens_json("vectors.json")["streams"][0];
  const auto bytes = bytes_of_spaced_hex(stream["hex"]);
  for (const std::size_t piece : {std::size_t{1}, std::size_t{7}, bytes.size()}) {
    FrameFinder finder = xsens::make_frame_finder();
    std::vector<std::pair<std::uint64_t, std::uint64_t>> found, wanted;
    for (std::size_t at = 0; at < bytes.size(); at += piece) {
      finder.push(std::span(bytes).subspan(at, std::min(piece, bytes.size() - at)));
      while (const auto stretch = finder.next()) {
        if (stretch->whole) found.emplace_back(stretch->offset, stretch->length);
      }
    }
    for (const json& frame : stream["expected_frames"]) wanted.emplace_back(frame["offset"], frame["total_len"]);
    EXPECT_EQ(found, wanted);
  }
}

TEST(Items, TheSizeByteDecidesNotTheIdentifier) {
  // A pressure tagged double that carries 4 bytes, as recorded; a float tagged double; and one whose size fits nothing.
  const auto items = xsens::parse_mtdata2(std::vector<std::uint8_t>{0x30, 0x13, 4, 0,    1,    0x86, 0xE1,  //
                                                                    0x08, 0x13, 4, 0x42, 0x16, 0x80, 0,     //
                                                                    0x08, 0x10, 3, 1,    2,    3});
  EXPECT_EQ(std::get<std::uint32_t>(items[0].value), 100065U);
  EXPECT_EQ(std::get<xsens::Numbers>(items[1].value), xsens::Numbers{37.625});
  EXPECT_EQ(items[2].name, "unknown");
  EXPECT_THROW(xsens::parse_mtdata2(std::vector<std::uint8_t>{0x30, 0x13, 4, 0, 1}), xsens::BadMessage);
}

}  // namespace
}  // namespace scanway::test
