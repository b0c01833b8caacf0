#include "modules/tools/decode/decode_lms.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>

#include <nlohmann/json.hpp>

#include "tests/support/command.h"

namespace scanway {
namespace {

using Json = nlohmann::json;

const std::string kData = SCANWAY_SHARED_DIR "/facts/sick/data/";

#define SKIP_WITHOUT_DATA() \
  if (!std::filesystem::exists(kData)) GTEST_SKIP() << "the recorded telegrams are not at " << kData

std::string recorded(const std::string& name) { return test::read_text(kData + name); }

std::vector<Json> decode(const std::string& bytes) {
  std::ostringstream out;
  tools::decode_lms(std::span(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()), out);
  std::vector<Json> lines;
  std::istringstream in(out.str());
  for (std::string line; std::getline(in, line);) lines.push_back(Json::parse(line));
  return lines;
}

void expect_scan(const Json& line, const Json& said, const char* dialect) {
  EXPECT_EQ(line["type"], "LMDscandata");
  EXPECT_EQ(line["dialect"], dialect);
  EXPECT_EQ(line["scan_counter"], said["scan_counter"]);
  EXPECT_EQ(line["telegram_counter"], said["telegram_counter"]);
  EXPECT_EQ(line["device_time_us"], said["time_since_startup_us"]);
  const Json& channel = said["channels_16bit"][0];
  EXPECT_DOUBLE_EQ(line["start_angle_deg"], channel["start_angle_raw"].get<int>() / 1e4);
  EXPECT_DOUBLE_EQ(line["step_deg"], channel["step_raw"].get<int>() / 1e4);
  ASSERT_EQ(line["ranges_m"].size(), channel["count"]);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_DOUBLE_EQ(line["ranges_m"][i].get<double>() * 1e3, channel["range_mm_first4"][i]);
  }
  if (said["channels_8bit"].empty()) {
    EXPECT_EQ(line["rssi"], Json::array());
    return;
  }
  ASSERT_EQ(line["rssi"].size(), said["channels_8bit"][0]["count"]);
  for (std::size_t i = 0; i < 8; ++i) EXPECT_EQ(line["rssi"][i], said["channels_8bit"][0]["raw_first8"][i]);
}

TEST(DecodeLms, RecordedScansInTheirKeys) {
  SKIP_WITHOUT_DATA();
  for (const char* name :
       {"lms511_colab_25hz_0.1667_scan_a", "lms511_colab_25hz_0.1667_scan_b", "lms511_colab_25hz_0.1667_status_not_ok",
        "lms111_colab_50hz_0.5_no_rssi", "lms511_colaa_25hz_0.1667_scan_a_transcoded"}) {
    const auto lines = decode(recorded(std::string(name) + ".bin"));
    ASSERT_EQ(lines.size(), 1U) << name;
    const Json side = Json::parse(recorded(std::string(name) + ".bin.json"));
    expect_scan(lines[0], side["decoded"], side["encoding"] == "CoLa-A" ? "cola_a" : "cola_b");
  }
  const auto interlaced = decode(recorded("lms5xx_colaa_100hz_interlaced_stream5.bin"));
  const Json side = Json::parse(recorded("lms5xx_colaa_100hz_interlaced_stream5.bin.json"));
  ASSERT_EQ(interlaced.size(), 5U);
  for (std::size_t i = 0; i < 5; ++i) expect_scan(interlaced[i], side["per_telegram"][i], "cola_a");
}

TEST(DecodeLms, NoReturnIsNullAndFurtherEchoesFollow) {
  SKIP_WITHOUT_DATA();
  for (const char* dialect : {"a", "b"}) {
    const auto one = decode(recorded(std::string("derived_encoder_rssi_time_cola") + dialect + ".bin")).at(0);
    EXPECT_EQ(one["ranges_m"], Json::parse("[1.303, 1.299, null, null, 0.016, 65.0, 0.628]"));
    EXPECT_EQ(one["rssi"], Json::parse("[254, 200, 0, 255, 10, 9, 8]"));
    EXPECT_EQ(one["encoders"][0]["position_ticks"], 74565);
    const auto five = decode(recorded(std::string("derived_encoder_two_5echo_scale2_cola") + dialect + ".bin")).at(0);
    EXPECT_EQ(five["ranges_m"], Json::parse("[2.0, 80.0, null]"));
    EXPECT_EQ(five["further_echoes"].size(), 4U);
    EXPECT_EQ(five["further_echoes"][3]["ranges_m"], Json::parse("[2.008, 80.0, null]"));
    const auto event = decode(recorded(std::string("derived_event_fdin_cola") + dialect + ".bin")).at(0);
    EXPECT_EQ(event["events"][0]["time_us"], 1000500);
  }
}

TEST(DecodeLms, BrokenStretchesAreMarkedWhereTheyAre) {
  SKIP_WITHOUT_DATA();
  std::string stream = recorded("lms511_colab_25hz_0.1667_stream10.bin");
  stream[3553 + 1000] ^= 4;
  stream = "noise" + stream.substr(0, stream.size() - 100);
  const auto lines = decode(stream);
  ASSERT_EQ(lines.size(), 11U);
  EXPECT_EQ(lines[0], Json::parse(R"({"type":"bad","offset":0,"length":5,"reason":"no frame begins here"})"));
  EXPECT_EQ(lines[2]["type"], "bad");
  EXPECT_EQ(lines[2]["offset"], 5 + 3553);
  EXPECT_EQ(lines[2]["length"], 3553);
  EXPECT_EQ(lines[2]["reason"], "wrong checksum");
  EXPECT_EQ(lines[10]["type"], "bad");
  EXPECT_EQ(lines[10]["reason"], "the stream ends within a frame");
  EXPECT_EQ(lines[10]["length"], 3453);
}

TEST(DecodeLms, DialoguesByCommandAndName) {
  SKIP_WITHOUT_DATA();
  std::string stream;
  std::istringstream session(recorded("lms511_colab_session_20210302.jsonl"));
  std::size_t count = 0;
  for (std::string line; std::getline(session, line); ++count) {
    const std::string hex = Json::parse(line)["hex"];
    for (std::size_t i = 0; i < hex.size(); i += 2)
      stream += static_cast<char>(std::stoi(hex.substr(i, 2), nullptr, 16));
  }
  const auto lines = decode(stream);
  ASSERT_EQ(lines.size(), count);
  EXPECT_EQ(lines[1]["type"], "sAN");
  EXPECT_EQ(lines[1]["name"], "SetAccessMode");
  EXPECT_EQ(lines[1]["accepted"], 1);
  EXPECT_EQ(std::count_if(lines.begin(), lines.end(), [](const Json& line) { return line["type"] == "LMDscandata"; }),
            5);
  EXPECT_EQ(std::count_if(lines.begin(), lines.end(), [](const Json& line) { return line["type"] == "bad"; }), 0);
}

}  // namespace
}  // namespace scanway
