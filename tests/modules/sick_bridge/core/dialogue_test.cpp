#include "modules/sick_bridge/core/dialogue.h"

#include "tests/modules/sick_bridge/hostile_lms.h"
#include "tests/modules/sick_bridge/scripted_lms.h"
#include "tests/modules/sick_bridge/yes_man.h"

namespace scanway::test {
namespace {

using sick::Dialect;
using sick::Dialogue;

constexpr Utime kSecond = kMicrosecondsPerSecond;

void receive(Dialogue& dialogue, const std::string& bytes, Utime now) {
  dialogue.receive(std::span(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()), now);
}

std::string all_notes(Dialogue& dialogue) {
  std::string all;
  for (const std::string& note : dialogue.take_notes()) all += note + '\n';
  return all;
}

TEST(Dialogue, TheRecordedLms511GoesFromTheFirstByteToItsScans) {
  SKIP_WITHOUT_LMS_DATA();
  ScriptedLms device;
  Dialogue dialogue({}, 0);
  Utime now = 0;
  for (int i = 0; i < 200 && dialogue.counters().scans == 0; ++i, now += 1000) {
    const std::string answer = device.answer(dialogue.take_output());
    // In pieces of every length.
    for (std::size_t at = 0; at < answer.size(); at += 97) receive(dialogue, answer.substr(at, 97), now);
    dialogue.tick(now);
  }
  EXPECT_EQ(dialogue.state(), Dialogue::State::measuring);
  EXPECT_EQ(dialogue.dialect(), Dialect::cola_b);
  EXPECT_EQ(dialogue.info().firmware, "V1.80");
  EXPECT_EQ(dialogue.info().location_name, "SN 18110550");
  EXPECT_DOUBLE_EQ(dialogue.info().operating_hours.value(), 119.5);
  EXPECT_EQ(dialogue.info().power_on_count, 99U);
  EXPECT_EQ(dialogue.counters().scans, 5U);
  EXPECT_EQ(dialogue.counters().missed_scans, 0U);
  EXPECT_EQ(dialogue.counters().bad_bytes, 0U);
  // DeviceIdent, LCMstate, STlms, LMPscancfg, mLMPsetscancfg and FREchoFilter are in no recording.
  EXPECT_EQ(device.unknown_requests(), 6);
  EXPECT_EQ(dialogue.counters().errors, 6U);
  EXPECT_NE(all_notes(dialogue).find("the device does not take the scan mode: unknown variable"), std::string::npos);
  std::vector<std::uint16_t> counters;
  for (const auto& received : dialogue.take_received()) {
    if (received.scan) counters.push_back(received.scan->telegram_counter);
  }
  EXPECT_EQ(counters, (std::vector<std::uint16_t>{54098, 54099, 54100, 54101, 54102}));
}

/// Lets both talk for so long, in steps of 50 ms; what the device sends beside its answers comes after each step.
void talk(Dialogue& dialogue, YesMan& device, Utime& now, Utime how_long, const std::string& more = {}) {
  for (const Utime end = now + how_long; now < end; now += kSecond / 20) {
    receive(dialogue, device.answer(dialogue.take_output()) + more, now);
    dialogue.tick(now);
  }
}

TEST(Dialogue, FindsOutEachDialectByItself) {
  for (const Dialect spoken : {Dialect::cola_a, Dialect::cola_b}) {
    for (const Dialect tried_first : {Dialect::cola_a, Dialect::cola_b}) {
      sick::LmsConfig config;
      config.first_dialect = tried_first;
      Dialogue dialogue(config, 0);
      YesMan device(spoken);
      Utime now = 0;
      talk(dialogue, device, now, 6 * kSecond);
      EXPECT_EQ(dialogue.state(), Dialogue::State::measuring);
      EXPECT_EQ(dialogue.dialect(), spoken);
    }
  }
}

TEST(Dialogue, FollowsSicksOrderAndLeavesARightScanModeAlone) {
  Dialogue dialogue({}, 0);
  YesMan device(Dialect::cola_a);
  Utime now = 0;
  talk(dialogue, device, now, 4 * kSecond);
  const auto login = std::find(device.asked.begin(), device.asked.end(), "sMN SetAccessMode");
  const std::vector<std::string> settings(login, device.asked.end());
  EXPECT_EQ(settings,
            (std::vector<std::string>{"sMN SetAccessMode", "sWN FREchoFilter", "sWN LMDscandatacfg",
                                      "sWN LMPoutputRange", "sMN LMCstartmeas", "sMN Run", "sEN LMDscandata"}));
}

TEST(Dialogue, SetsAScanModeThatIsNotRight) {
  Dialogue dialogue({}, 0);
  YesMan device(Dialect::cola_a);
  device.read_back = "1388 1 1388 FFFF3CB0 1C3A90";
  device.scan_config_status = "2";
  Utime now = 0;
  talk(dialogue, device, now, 4 * kSecond);
  EXPECT_EQ(std::count(device.asked.begin(), device.asked.end(), "sMN mLMPsetscancfg"), 1);
  EXPECT_NE(all_notes(dialogue).find("does not take the scan mode: it does not accept the resolution"),
            std::string::npos);
}

TEST(Dialogue, SaysThatTheLoginWasRefusedAndGoesOn) {
  Dialogue dialogue({}, 0);
  YesMan device(Dialect::cola_b);
  device.login = "0";
  Utime now = 0;
  talk(dialogue, device, now, 4 * kSecond);
  EXPECT_EQ(dialogue.state(), Dialogue::State::measuring);
  EXPECT_NE(all_notes(dialogue).find("the device does not accept the login: it answers 0"), std::string::npos);
}

TEST(Dialogue, WaitsHalfAMinuteForTheFirstScanAndFailsWhenScansStop) {
  Dialogue dialogue({}, 0);
  YesMan device(Dialect::cola_b);
  Utime now = 0;
  talk(dialogue, device, now, 33 * kSecond);
  EXPECT_EQ(dialogue.state(), Dialogue::State::measuring);
  const Bytes scan = small_scan(1);
  talk(dialogue, device, now, 2 * kSecond, {scan.begin(), scan.end()});
  EXPECT_EQ(dialogue.state(), Dialogue::State::measuring);
  talk(dialogue, device, now, 6 * kSecond);
  EXPECT_EQ(dialogue.state(), Dialogue::State::failed);
  EXPECT_EQ(dialogue.failure(), "no scan for 5 s");
}

TEST(Dialogue, AsksForStatusWhileItMeasuresAndForgetsWhatTheDeviceDoesNotKnow) {
  Dialogue dialogue({}, 0);
  YesMan device(Dialect::cola_b);
  Utime now = 0;
  const Bytes scan = small_scan(1);
  talk(dialogue, device, now, 30 * kSecond, {scan.begin(), scan.end()});
  EXPECT_EQ(dialogue.info().contamination, 1U);
  EXPECT_EQ(dialogue.info().device_state, 1U);
  EXPECT_GE(std::count(device.asked.begin(), device.asked.end(), "sRN LCMstate"), 3);
}

TEST(Dialogue, CountsScansThatAreMissingOverTheWrapOfTheCounter) {
  Dialogue dialogue({}, 0);
  YesMan device(Dialect::cola_b);
  Utime now = 0;
  talk(dialogue, device, now, kSecond);
  for (const int counter : {65534, 65535, 0, 3, 4, 4000}) {
    dialogue.receive(small_scan(static_cast<std::uint16_t>(counter)), now);
  }
  EXPECT_EQ(dialogue.counters().missed_scans, 2U + 3995U);
  EXPECT_EQ(dialogue.counters().missed_telegrams, 2U + 3995U);
}

TEST(Dialogue, SaysWhenNothingAnswersOrSomethingElseDoes) {
  Dialogue silent({}, 0);
  for (Utime now = 0; now < 40 * kSecond; now += kSecond / 2) silent.tick(now);
  EXPECT_EQ(silent.state(), Dialogue::State::failed);
  EXPECT_NE(silent.failure().find("does not answer"), std::string::npos);
  Dialogue other({}, 0);
  receive(other, "220 ftp.example ready\r\n", 0);
  for (Utime now = 0; now < 40 * kSecond; now += kSecond / 2) other.tick(now);
  EXPECT_NE(other.failure().find("neither CoLa-A nor CoLa-B"), std::string::npos);
}

TEST(Dialogue, SaysThatScansComeInAnotherModeThanAskedFor) {
  sick::LmsConfig config;
  config.scan.frequency = 5000;
  config.scan.resolution = 5000;
  Dialogue dialogue(config, 0);
  YesMan device(Dialect::cola_b);
  Utime now = 0;
  talk(dialogue, device, now, kSecond);
  dialogue.receive(small_scan(1), now);
  EXPECT_NE(all_notes(dialogue).find("the scans come at 25 Hz with 0.1667 deg, not at the 50 Hz with 0.5 deg"),
            std::string::npos);
}

}  // namespace
}  // namespace scanway::test
