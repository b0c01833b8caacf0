#include "modules/sick_bridge/core/scan_geometry.h"

#include <gtest/gtest.h>

namespace scanway::sick {
namespace {

ScanChannel channel_of(std::uint16_t step, std::size_t beams) {
  ScanChannel channel;
  channel.content = "DIST1";
  channel.start_angle = -50000;
  channel.step = step;
  channel.counts.assign(beams, 1000);
  return channel;
}

TEST(ScanGeometry, LastBeamOfAFullScanIsAtItsEnd) {
  // 1667/10000 deg is 1/6 deg rounded: taken at its word the last of 1141 beams would be 0.038 deg off.
  EXPECT_NEAR(beam_angle_deg(channel_of(1667, 1141), 1140), 185.0, 1e-9);
  EXPECT_NEAR(beam_angle_deg(channel_of(6667, 286), 285), 185.0, 1e-9);
  EXPECT_NEAR(beam_angle_deg(channel_of(3333, 571), 570), 185.0, 1e-9);
  EXPECT_NEAR(beam_angle_deg(channel_of(2500, 761), 760), 185.0, 1e-9);
  EXPECT_NEAR(beam_angle_deg(channel_of(5000, 381), 380), 185.0, 1e-9);
  EXPECT_NEAR(beam_angle_deg(channel_of(10000, 191), 190), 185.0, 1e-9);
}

TEST(ScanGeometry, BeamTimesFollowFrequencyAndStep) {
  struct Case {
    std::uint32_t frequency;
    std::uint16_t step;
    double shots_per_second;
  };
  // The measurement frequencies that recorded telegrams state: 54 kHz, and 36 kHz at 50 Hz with 0.5 deg.
  for (const Case& known : {Case{2500, 1667, 54000}, Case{10000, 6667, 54000}, Case{5000, 5000, 36000}}) {
    Scan scan;
    scan.scan_frequency = known.frequency;
    EXPECT_NEAR(beam_period_us(scan, channel_of(known.step, 2)).value(), 1e6 / known.shots_per_second, 1e-9);
  }
  EXPECT_FALSE(beam_period_us(Scan{}, channel_of(1667, 2)).has_value());
}

TEST(ScanGeometry, RangesHaveScaleAndOffset) {
  ScanChannel channel = channel_of(1667, 0);
  channel.scale = 2.0F;
  channel.offset = 5.0F;
  channel.counts = {0, 1, 15, 16, 40000, 65535};
  EXPECT_FALSE(range_m(channel, 0) || range_m(channel, 1) || range_m(channel, 2));
  EXPECT_DOUBLE_EQ(range_m(channel, 3).value(), 0.037);
  EXPECT_DOUBLE_EQ(range_m(channel, 4).value(), 80.005);
}

TEST(ScanGeometry, KnowsTheModesOfTheLms5xx) {
  EXPECT_TRUE(is_mode_of_lms5xx(2500, 1667));
  EXPECT_TRUE(is_mode_of_lms5xx(10000, 6667));
  EXPECT_FALSE(is_mode_of_lms5xx(2500, 3333));
  EXPECT_TRUE(find_mode(10000, 1667)->interlaced);
  EXPECT_FALSE(find_mode(5000, 3333)->interlaced);
}

}  // namespace
}  // namespace scanway::sick
