// Whatever comes over the line, an emulator goes on, and answers the next good request.
#include <gtest/gtest.h>

#include <cmath>

#include "common/random/random.h"
#include "modules/simulator/device/base/base_emulator.h"
#include "modules/simulator/device/lms/lms_emulator.h"
#include "modules/simulator/device/pan_tilt/pan_tilt_module.h"
#include "modules/simulator/device/tracker/tracker_emulator.h"

namespace scanway::test {
namespace {

using namespace simulator;

constexpr int kStreams = 2000;

/// Bytes of any kind, many of them taken from `likely`.
std::string noise(Random& random, const std::string& likely) {
  std::string bytes;
  for (auto left = random.below(80); left > 0; --left) {
    bytes += random.below(3) == 0 ? static_cast<char>(random.below(256)) : likely[random.below(likely.size())];
  }
  return bytes;
}

std::vector<std::uint8_t> bytes_of(const std::string& text) { return {text.begin(), text.end()}; }

TEST(HostileHost, TheLmsGoesOn) {
  Random random(1);
  LmsEmulator lms([](const MirrorTurn& turn) {
    const auto beams = static_cast<std::size_t>(turn.sector.beams);
    return ScannedLine{1.0, std::vector<std::uint16_t>(beams), std::vector<std::uint8_t>(beams)};
  });
  const std::string likely =
      "\x02\x02\x02\x03 sRN sWN sMN sEN LMDscandatacfg LMPoutputRange mLMPsetscancfg +-0123456789ABCDEF";
  const char* const kNames[] = {"LMDscandatacfg", "LMPoutputRange", "LSPsetdatetime", "mLMPsetscancfg",
                                "LMDscandata",    "FREchoFilter",   "SetAccessMode"};
  const char* const kCommands[] = {"sRN", "sWN", "sMN", "sEN"};
  Utime now = 0;
  std::size_t scans = 0;
  lms.receive("\x02sEN LMDscandata 1\x03", now);
  for (int i = 0; i < kStreams; ++i, now += 20'000) {
    lms.receive("\x02sMN SetAccessMode 03 F4724744\x03", now);
    lms.receive(noise(random, likely), now);
    std::string request = std::string("\x02") + kCommands[random.below(4)] + ' ' + kNames[random.below(7)];
    for (auto values = random.below(14); values > 0; --values) {
      request += ' ' + std::to_string(random.below(random.below(2) == 0 ? 3 : 0xFFFFFFFF));
    }
    lms.receive(request + '\x03', now);
    scans += lms.tick(now).size();
  }
  EXPECT_GT(scans, 0U);
  EXPECT_LE(scans, static_cast<std::size_t>(kStreams));
  std::string answer;
  for (int i = 0; i < 500 && answer.empty(); ++i) answer = lms.receive("\x02sRN LMPscancfg\x03", now);
  EXPECT_NE(answer.find("LMPscancfg"), std::string::npos);
}

TEST(HostileHost, TheModuleGoesOnAndStaysWithinItsLimits) {
  Random random(2);
  ModuleConfig config;
  config.referenced = true;
  PanTiltModule module(config);
  Utime now = 0;
  for (int i = 0; i < 20 * kStreams; ++i, now += static_cast<Utime>(random.below(50'000))) {
    CanFrame frame;
    frame.id = 0x50B;
    frame.size = static_cast<std::uint8_t>(random.below(9));
    for (std::uint8_t& byte : frame.data) byte = static_cast<std::uint8_t>(random.below(256));
    constexpr std::uint8_t kLikely[] = {0x80, 0x81, 0x84, 0x86, 0x8B, 0x91, 0x92, 0x95, 0xA0, 0xA1, 0xB0, 0xB5, 0xB8};
    if (random.below(4) != 0) frame.data[0] = static_cast<std::uint8_t>(random.below(10));
    if (random.below(4) != 0) frame.data[1] = kLikely[random.below(std::size(kLikely))];
    if (random.below(2) != 0) frame.data[5] = static_cast<std::uint8_t>(0x40 | random.below(2) << 7 | random.below(3));
    module.receive(frame, now);
    module.tick(now);
    ASSERT_LT(module.take_frames().size(), 100U);
    ASSERT_TRUE(std::isfinite(module.angle(now)));
    ASSERT_LE(std::fabs(module.speed(now)), config.max_speed * (1 + 1e-6)) << i;
  }
}

TEST(HostileHost, TheTrackerAndTheBaseGoOn) {
  Random random(3);
  TrackerEmulator tracker([](std::int64_t, Utime) { return TrackerSample(); });
  BaseEmulator base;
  Utime now = 0;
  for (int i = 0; i < kStreams; ++i, now += 10'000) {
    tracker.receive(bytes_of(noise(random, "\xFA\xFF\x30\x10\xC0\x04\x20\x10")), now);
    XbusBytes data;
    for (auto left = random.below(12); left > 0; --left) data.push_back(static_cast<std::uint8_t>(random.below(256)));
    tracker.receive(xbus_message(0x30), now);
    tracker.receive(xbus_message(static_cast<std::uint8_t>(random.below(256)), data), now);
    base.receive(bytes_of(noise(random, "\xFA\xFB\x03\x06\x3B\x1B\x0B")), now);
    base.receive(base_packet(data), now);
    EXPECT_LT(tracker.tick(now).size() + base.tick(now).size(), 60'000U);
  }
  bool tracker_answers = false, base_answers = false;
  for (int i = 0; i < 300; ++i) {
    tracker_answers = tracker_answers || !tracker.receive(xbus_message(0x30), now).empty();
    base_answers = base_answers || !base.receive(base_packet(std::vector<std::uint8_t>{18}), now).empty();
  }
  EXPECT_TRUE(tracker_answers && base_answers);
}

}  // namespace
}  // namespace scanway::test
