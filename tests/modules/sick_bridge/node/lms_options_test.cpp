#include "modules/sick_bridge/node/lms_options.h"

#include <gtest/gtest.h>

#include "common/files/input_error.h"

namespace scanway::test {
namespace {

using sick::lms_config;

TEST(LmsOptions, FollowTheRobotFile) {
  const sick::LmsConfig usual = lms_config({}, {});
  EXPECT_EQ(usual.scan, sick::ScanConfig{});
  EXPECT_EQ(usual.sector_start, -50000);
  EXPECT_EQ(usual.sector_stop, 1850000);
  EXPECT_TRUE(usual.content.rssi);
  Robot::Laser half;
  half.line_rate_hz = 50;
  half.field_of_view = radians(180);
  half.beams = 361;
  const sick::LmsConfig config = lms_config({}, half);
  EXPECT_EQ(config.scan.frequency, 5000U);
  EXPECT_EQ(config.scan.resolution, 5000U);
  EXPECT_EQ(config.sector_start, 0);
  EXPECT_EQ(config.sector_stop, 1800000);
}

TEST(LmsOptions, TheCommandLineGoesFirst) {
  sick::LmsOptions options;
  options.frequency_hz = 100;
  options.resolution_deg = 0.1667;
  options.sector_deg = std::pair(0.0, 90.0);
  options.echo = "all";
  options.rssi_bits = 0;
  options.store = true;
  const sick::LmsConfig config = lms_config(options, {});
  EXPECT_EQ(config.scan.frequency, 10000U);
  EXPECT_EQ(config.scan.resolution, 1667U);
  EXPECT_EQ(config.sector_start, 0);
  EXPECT_EQ(config.sector_stop, 900000);
  EXPECT_EQ(config.echo, sick::EchoFilter::all);
  EXPECT_FALSE(config.content.rssi);
  EXPECT_TRUE(config.store);
}

std::string refusal(const sick::LmsOptions& options) {
  try {
    lms_config(options, {});
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(LmsOptions, WhatNoLms5xxCanDoIsOneLine) {
  sick::LmsOptions frequency, sector, echo, rssi;
  frequency.frequency_hz = 33;
  sector.sector_deg = std::pair(-10.0, 90.0);
  echo.echo = "second";
  rssi.rssi_bits = 12;
  EXPECT_NE(refusal(frequency).find("no LMS5xx scans at 33 Hz with 0.1667 degrees"), std::string::npos);
  EXPECT_NE(refusal(sector).find("--sector -10,90"), std::string::npos);
  EXPECT_NE(refusal(echo).find("--echo second: choose"), std::string::npos);
  EXPECT_NE(refusal(rssi).find("--rssi 12: choose"), std::string::npos);
}

}  // namespace
}  // namespace scanway::test
