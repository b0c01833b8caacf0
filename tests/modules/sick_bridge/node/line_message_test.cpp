#include "modules/sick_bridge/node/line_message.h"

#include <cmath>

#include "common/random/random.h"
#include "modules/sick_bridge/core/scan_geometry.h"
#include "tests/modules/sick_bridge/shared_lms.h"
#include "tests/modules/sick_bridge/whole_line.h"

namespace scanway::test {
namespace {

sick::ScanChannel channel(const std::string& content, std::size_t beams, int bits, Random& random) {
  sick::ScanChannel channel;
  channel.content = content;
  channel.scale = bits == 16 ? 2.0F : 1.0F;
  channel.start_angle = -50000;
  channel.step = 1667;
  for (std::size_t i = 0; i < beams; ++i) {
    channel.counts.push_back(static_cast<std::uint16_t>(random.below(std::uint64_t{1} << bits)));
  }
  return channel;
}

/// A scan of that many echoes; `rssi_bits` 0, 8 or 16.
sick::Scan scan_of(std::size_t beams, int echoes, int rssi_bits, Random& random) {
  sick::Scan scan;
  scan.scan_frequency = 2500;
  scan.start_time_us = static_cast<std::uint32_t>(random.below(std::uint64_t{1} << 32));
  scan.device_status = 5;
  for (int echo = 1; echo <= echoes; ++echo) {
    scan.channels_16_bit.push_back(channel("DIST" + std::to_string(echo), beams, 16, random));
    auto& rssi = rssi_bits == 16 ? scan.channels_16_bit : scan.channels_8_bit;
    if (rssi_bits > 0) rssi.push_back(channel("RSSI" + std::to_string(echo), beams, rssi_bits, random));
  }
  return scan;
}

std::vector<int> counts_of(const sick::Scan& scan, const std::string& content) {
  const sick::ScanChannel* const found = scan.channel(content);
  if (found == nullptr) return {};
  return {found->counts.begin(), found->counts.end()};
}

void expect_pieces_are_the_scan(const sick::Scan& scan, int echoes) {
  WholeLines lines;
  for (const laser_line_t& piece : line_messages(scan, {42, 1234, 5678})) {
    const auto bytes = encode(piece);
    ASSERT_LE(bytes.size(), sick::kMaxLineBytes);
    ASSERT_GT(piece.nbeams, 0);
    EXPECT_EQ(piece.line, 42);
    EXPECT_EQ(piece.numbered_since, 1234);
    EXPECT_EQ(piece.utime, 5678);
    EXPECT_EQ(piece.device_time_us, scan.start_time_us);
    EXPECT_EQ(piece.device_status, 5);
    lines.add(bytes);
  }
  ASSERT_EQ(lines.lines().size(), static_cast<std::size_t>(echoes));
  for (const auto& [key, echo] : lines.lines()) {
    const std::string number = std::to_string(key.second + 1);
    EXPECT_TRUE(echo.whole());
    EXPECT_EQ(echo.ranges, counts_of(scan, "DIST" + number));
    EXPECT_EQ(echo.rssi, counts_of(scan, "RSSI" + number));
    EXPECT_FLOAT_EQ(echo.head.range_scale_m, 0.002F);
  }
}

TEST(LineMessages, PiecesAreTheScanWhateverItsSize) {
  Random random(5);
  for (int echoes = 1; echoes <= 5; ++echoes) {
    for (const int rssi_bits : {0, 8, 16}) {
      for (int i = 0; i < 60; ++i) {
        const std::size_t beams = i < 3 ? 1 + i : 1 + random.below(i < 50 ? 1300 : 9000);
        expect_pieces_are_the_scan(scan_of(beams, echoes, rssi_bits, random), echoes);
      }
    }
  }
}

TEST(LineMessages, PiecesAreFullAndNoneIsEmptyAtTheSizesWhereOneMoreBegins) {
  Random random(6);
  const auto pieces = [&](std::size_t beams, int rssi_bits) {
    return line_messages(scan_of(beams, 1, rssi_bits, random), {}).size();
  };
  std::size_t full = 0;
  while (pieces(full + 1, 8) == 1) ++full;
  EXPECT_EQ(full, 300U);
  EXPECT_EQ(pieces(4 * full, 8), 4U);
  EXPECT_EQ(pieces(4 * full + 1, 8), 5U);
  EXPECT_EQ(pieces(1141, 8), 4U);
  EXPECT_EQ(pieces(1141, 0), 2U);
}

TEST(LineMessages, AScanWithoutRangesOrFrequencyIsNone) {
  Random random(7);
  sick::Scan scan = scan_of(10, 1, 8, random);
  scan.scan_frequency = 0;
  EXPECT_TRUE(line_messages(scan, {}).empty());
  EXPECT_TRUE(line_messages(sick::Scan{}, {}).empty());
  EXPECT_EQ(sick::lidar_message(sick::Scan{}, 5).nranges, 0);
}

TEST(LineMessages, RssiOfAnotherLengthIsLeftOut) {
  Random random(8);
  sick::Scan scan = scan_of(400, 1, 8, random);
  scan.channels_8_bit[0].counts.pop_back();
  for (const laser_line_t& piece : line_messages(scan, {})) EXPECT_EQ(piece.nrssi, 0);
  EXPECT_EQ(sick::lidar_message(scan, 5).nintensities, 0);
}

struct Mode {
  double frequency_hz;
  double resolution_deg;  ///< Between two beams of one turn.
};

class EachMode : public testing::TestWithParam<Mode> {};

// A turn is 360 degrees of as many beams as the step makes, also when several shifted turns make up one resolution.
TEST_P(EachMode, BeamTimesFollowThePair) {
  Random random(9);
  const auto [frequency, resolution] = GetParam();
  sick::Scan scan = scan_of(100, 1, 0, random);
  scan.scan_frequency = static_cast<std::uint32_t>(std::lround(100 * frequency));
  scan.channels_16_bit[0].step = static_cast<std::uint16_t>(std::lround(1e4 * resolution));
  const laser_line_t piece = line_messages(scan, {}).at(0);
  const double beams_of_a_turn = std::round(360 / resolution);
  EXPECT_NEAR(piece.beam_period_us * beams_of_a_turn, 1e6 / frequency, 1e-6);
  EXPECT_NEAR(piece.angle_step_rad * beams_of_a_turn, 2 * M_PI, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(All, EachMode,
                         testing::Values(Mode{25, 1.0 / 6}, Mode{25, 0.25}, Mode{35, 0.25}, Mode{35, 0.5},
                                         Mode{50, 1.0 / 3}, Mode{50, 0.5}, Mode{75, 0.5}, Mode{75, 1},
                                         Mode{100, 2.0 / 3}, Mode{100, 1},
                                         // Interlaced: what one turn has.
                                         Mode{50, 1.0 / 3}, Mode{75, 0.5}, Mode{100, 2.0 / 3}, Mode{25, 1.0 / 6}));

TEST(LineMessages, InterlacedTurnsBeginAtTheirOwnAngles) {
  SKIP_WITHOUT_LMS_DATA();
  const auto said = lms_json("lms5xx_colaa_100hz_interlaced_stream5.bin.json")["per_telegram"];
  const auto telegrams = telegrams_in(lms_bytes("lms5xx_colaa_100hz_interlaced_stream5.bin"));
  ASSERT_EQ(telegrams.size(), said.size());
  for (std::size_t i = 0; i < telegrams.size(); ++i) {
    const auto pieces = line_messages(parse_scan(telegrams[i]), {static_cast<std::int64_t>(i), 0, 0});
    ASSERT_EQ(pieces.size(), 1U);
    const auto& channel = said[i]["channels_16bit"][0];
    EXPECT_EQ(pieces[0].nbeams_of_line, channel["count"]);
    EXPECT_NEAR(pieces[0].start_angle_rad, channel["start_angle_raw"].get<double>() / 1e4 * M_PI / 180, 1e-9);
    // The telegram says it in other words: so many hundred shots a second.
    EXPECT_NEAR(pieces[0].beam_period_us, 1e4 / said[i]["measurement_frequency_100Hz"].get<double>(), 1e-9);
    EXPECT_NEAR(pieces[0].angle_step_rad, 2.0 / 3 * M_PI / 180, 1e-12);
  }
}

TEST(LidarMessage, IsInMetres) {
  SKIP_WITHOUT_LMS_DATA();
  const std::string name = "lms511_colab_25hz_0.1667_scan_a.bin";
  const auto message = sick::lidar_message(parse_scan(telegrams_in(lms_bytes(name))[0]), 77);
  const auto said = lms_json(name + ".json")["decoded"]["channels_16bit"][0];
  EXPECT_EQ(message.utime, 77);
  ASSERT_EQ(message.nranges, said["count"]);
  EXPECT_EQ(message.nintensities, message.nranges);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_FLOAT_EQ(message.ranges[i], said["range_mm_first4"][i].get<float>() / 1000);
    EXPECT_FLOAT_EQ(message.ranges[message.ranges.size() - 4 + i], said["range_mm_last4"][i].get<float>() / 1000);
  }
  EXPECT_EQ(std::count(message.ranges.begin(), message.ranges.end(), sick::kNoReturn), said["count_raw_below_16"]);
  EXPECT_NEAR(message.rad0, -95 * M_PI / 180, 1e-5);
  EXPECT_NEAR(message.rad0 + 1140 * message.radstep, 95 * M_PI / 180, 1e-5);
}

}  // namespace
}  // namespace scanway::test
