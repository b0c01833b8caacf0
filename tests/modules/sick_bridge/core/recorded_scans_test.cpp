#include <numeric>

#include "modules/sick_bridge/core/scan_geometry.h"
#include "tests/modules/sick_bridge/shared_lms.h"

namespace scanway::test {
namespace {

using nlohmann::json;

std::uint16_t bits_of(const json& pair) {
  return static_cast<std::uint16_t>(pair[0].get<int>() + 256 * pair[1].get<int>());
}

template <class Part>
std::vector<std::uint16_t> ends(const std::vector<std::uint16_t>& counts, Part size, bool last) {
  return last ? std::vector<std::uint16_t>(counts.end() - size, counts.end())
              : std::vector<std::uint16_t>(counts.begin(), counts.begin() + size);
}

void expect_channel(const sick::ScanChannel& channel, const json& said) {
  const auto& counts = channel.counts;
  EXPECT_EQ(channel.content, said["name"]);
  EXPECT_EQ(channel.scale, said["scale"].get<float>());
  EXPECT_EQ(channel.offset, said["offset"].get<float>());
  EXPECT_EQ(channel.start_angle, said["start_angle_raw"]);
  EXPECT_EQ(channel.step, said["step_raw"]);
  ASSERT_EQ(counts.size(), said["count"]);
  EXPECT_EQ(json(ends(counts, 8, false)), said["raw_first8"]);
  EXPECT_EQ(json(ends(counts, 8, true)), said["raw_last8"]);
  EXPECT_EQ(std::accumulate(counts.begin(), counts.end(), 0L), said["raw_sum"]);
  EXPECT_EQ(*std::min_element(counts.begin(), counts.end()), said["raw_min"]);
  EXPECT_EQ(*std::max_element(counts.begin(), counts.end()), said["raw_max"]);
  if (!said.contains("range_mm_first4")) return;
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_DOUBLE_EQ(range_m(channel, i).value() * 1000.0, said["range_mm_first4"][i]);
    EXPECT_DOUBLE_EQ(range_m(channel, counts.size() - 4 + i).value() * 1000.0, said["range_mm_last4"][i]);
  }
  EXPECT_EQ(std::count_if(counts.begin(), counts.end(), [](int count) { return count < 16; }),
            said["count_raw_below_16"]);
}

void expect_date(const sick::DeviceDate& date, const json& said) {
  EXPECT_EQ(json({{"year", date.year},
                  {"month", date.month},
                  {"day", date.day},
                  {"hour", date.hour},
                  {"minute", date.minute},
                  {"second", date.second},
                  {"us", date.microsecond}}),
            said);
}

void expect_scan(const sick::Scan& scan, const json& said) {
  EXPECT_EQ(scan.version, said["version"]);
  EXPECT_EQ(scan.device_number, said["device_number"]);
  EXPECT_EQ(scan.serial_number, said["serial"]);
  EXPECT_EQ(scan.device_status, bits_of(said["device_status"]));
  EXPECT_EQ(scan.telegram_counter, said["telegram_counter"]);
  EXPECT_EQ(scan.scan_counter, said["scan_counter"]);
  EXPECT_EQ(scan.start_time_us, said["time_since_startup_us"]);
  EXPECT_EQ(scan.transmission_time_us, said["time_of_transmission_us"]);
  EXPECT_EQ(scan.digital_inputs, bits_of(said["digital_inputs"]));
  EXPECT_EQ(scan.digital_outputs, bits_of(said["digital_outputs"]));
  EXPECT_EQ(scan.reserved, said["layer_or_reserved"]);
  EXPECT_EQ(scan.scan_frequency, said["scan_frequency_centiHz"]);
  EXPECT_EQ(scan.measurement_frequency, said["measurement_frequency_100Hz"]);
  EXPECT_EQ(scan.encoders.size(), said["num_encoders"]);
  ASSERT_EQ(scan.channels_16_bit.size(), said["channels_16bit"].size());
  ASSERT_EQ(scan.channels_8_bit.size(), said["channels_8bit"].size());
  for (std::size_t i = 0; i < scan.channels_16_bit.size(); ++i) {
    expect_channel(scan.channels_16_bit[i], said["channels_16bit"][i]);
  }
  for (std::size_t i = 0; i < scan.channels_8_bit.size(); ++i) {
    expect_channel(scan.channels_8_bit[i], said["channels_8bit"][i]);
  }
  EXPECT_FALSE(scan.position || scan.device_name || scan.comment);
  EXPECT_TRUE(scan.events.empty());
  EXPECT_EQ(scan.unread_bytes, 0U);
  if (said.contains("time")) {
    ASSERT_TRUE(scan.date.has_value());
    expect_date(*scan.date, said["time"]);
  }
}

class RecordedScan : public testing::TestWithParam<const char*> {};

TEST_P(RecordedScan, DecodesToItsSideFile) {
  SKIP_WITHOUT_LMS_DATA();
  const std::string name = GetParam();
  const auto telegrams = telegrams_in(lms_bytes(name));
  ASSERT_EQ(telegrams.size(), 1U);
  expect_scan(parse_scan(telegrams[0]), lms_json(name + ".json")["decoded"]);
}

INSTANTIATE_TEST_SUITE_P(All, RecordedScan,
                         testing::Values("lms111_colab_50hz_0.5_no_rssi.bin",
                                         "lms511_colaa_25hz_0.1667_scan_a_transcoded.bin",
                                         "lms511_colab_25hz_0.1667_scan_a.bin", "lms511_colab_25hz_0.1667_scan_b.bin",
                                         "lms511_colab_25hz_0.1667_status_not_ok.bin"));

TEST(RecordedScans, BothDialectsSayTheSame) {
  SKIP_WITHOUT_LMS_DATA();
  const auto a = parse_scan(telegrams_in(lms_bytes("lms511_colaa_25hz_0.1667_scan_a_transcoded.bin"))[0]);
  const auto b = parse_scan(telegrams_in(lms_bytes("lms511_colab_25hz_0.1667_scan_a.bin"))[0]);
  EXPECT_EQ(a.channel("DIST1")->counts, b.channel("DIST1")->counts);
  EXPECT_EQ(a.channel("RSSI1")->counts, b.channel("RSSI1")->counts);
  EXPECT_EQ(a.date->microsecond, b.date->microsecond);
}

TEST(RecordedScans, AStreamOfTen) {
  SKIP_WITHOUT_LMS_DATA();
  const std::string name = "lms511_colab_25hz_0.1667_stream10.bin";
  const auto said = lms_json(name + ".json")["per_telegram"];
  const auto telegrams = telegrams_in(lms_bytes(name));
  ASSERT_EQ(telegrams.size(), said.size());
  for (std::size_t i = 0; i < telegrams.size(); ++i) {
    const sick::Scan scan = parse_scan(telegrams[i]);
    EXPECT_EQ(scan.telegram_counter, said[i]["telegram_counter"]);
    EXPECT_EQ(scan.scan_counter, said[i]["scan_counter"]);
    EXPECT_EQ(scan.start_time_us, said[i]["time_since_startup_us"]);
    EXPECT_EQ(scan.transmission_time_us, said[i]["time_of_transmission_us"]);
    expect_date(scan.date.value(), said[i]["time"]);
    EXPECT_EQ(json(ends(scan.channel("DIST1")->counts, 4, false)), said[i]["dist1_raw_first4"]);
    EXPECT_EQ(json(ends(scan.channel("DIST1")->counts, 4, true)), said[i]["dist1_raw_last4"]);
    EXPECT_EQ(json(ends(scan.channel("RSSI1")->counts, 4, false)), said[i]["rssi1_first4"]);
  }
}

TEST(RecordedScans, InterlacedTelegramsEachHaveTheirOwnStart) {
  SKIP_WITHOUT_LMS_DATA();
  const std::string name = "lms5xx_colaa_100hz_interlaced_stream5.bin";
  const auto said = lms_json(name + ".json")["per_telegram"];
  const auto telegrams = telegrams_in(lms_bytes(name));
  ASSERT_EQ(telegrams.size(), said.size());
  for (std::size_t i = 0; i < telegrams.size(); ++i) expect_scan(parse_scan(telegrams[i]), said[i]);
  // Four revolutions of 2/3 deg interlock to 1/6 deg.
  const sick::Scan second = parse_scan(telegrams[1]);
  EXPECT_NEAR(beam_angle_deg(*second.channel("DIST1"), 284), -5.0 + 2.0 / 6.0 + 284 * 4.0 / 6.0, 1e-4);
  EXPECT_NEAR(beam_period_us(second, *second.channel("DIST1")).value(), 1e4 / 540.0, 1e-9);
}

/// The derived vectors: blocks that no recording has.
class DerivedScan : public testing::TestWithParam<std::string> {};

std::vector<std::uint16_t> counts_of(const json& list) { return list.get<std::vector<std::uint16_t>>(); }

void expect_derived_channels(const std::vector<sick::ScanChannel>& channels, const json& said) {
  ASSERT_EQ(channels.size(), said.size());
  for (std::size_t i = 0; i < channels.size(); ++i) {
    EXPECT_EQ(channels[i].content, said[i][0]);
    EXPECT_EQ(channels[i].start_angle, said[i][1]);
    EXPECT_EQ(channels[i].step, said[i][2]);
    EXPECT_EQ(channels[i].counts, counts_of(said[i][3]));
    EXPECT_EQ(channels[i].scale, said[i].size() > 4 ? said[i][4].get<float>() : 1.0F);
  }
}

TEST_P(DerivedScan, DecodesToWhatItWasMadeOf) {
  SKIP_WITHOUT_LMS_DATA();
  const json said = lms_json("derived_scans.json")[GetParam()]["input"];
  const auto telegrams = telegrams_in(lms_bytes(GetParam()));
  ASSERT_EQ(telegrams.size(), 1U);
  const sick::Scan scan = parse_scan(telegrams[0]);
  ASSERT_EQ(scan.encoders.size(), said["enc"].size());
  for (std::size_t i = 0; i < scan.encoders.size(); ++i) {
    EXPECT_EQ(scan.encoders[i].position_ticks, said["enc"][i][0]);
    EXPECT_EQ(scan.encoders[i].speed, said["enc"][i][1]);
  }
  expect_derived_channels(scan.channels_16_bit, said["c16"]);
  expect_derived_channels(scan.channels_8_bit, said["c8"]);
  EXPECT_EQ(scan.date.has_value(), !said["time"].is_null());
  if (scan.date) {
    EXPECT_EQ(json({scan.date->year, scan.date->month, scan.date->day, scan.date->hour, scan.date->minute,
                    scan.date->second, scan.date->microsecond}),
              said["time"]);
  }
  ASSERT_EQ(scan.events.size(), said["event"].is_null() ? 0U : 1U);
  if (scan.events.empty()) return;
  EXPECT_EQ(scan.events[0].type, "FDIN");
  EXPECT_EQ(json({scan.events[0].encoder_position, scan.events[0].time_us, scan.events[0].angle}), said["event"]);
}

INSTANTIATE_TEST_SUITE_P(All, DerivedScan,
                         testing::Values("derived_encoder_rssi_time_colab.bin", "derived_encoder_rssi_time_colaa.bin",
                                         "derived_encoder_two_5echo_scale2_colab.bin",
                                         "derived_encoder_two_5echo_scale2_colaa.bin", "derived_event_fdin_colab.bin",
                                         "derived_event_fdin_colaa.bin"));

}  // namespace
}  // namespace scanway::test
