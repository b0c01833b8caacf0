#include "modules/xsens_bridge/core/dialogue.h"

#include "tests/modules/xsens_bridge/emulated_tracker.h"

namespace scanway::test {
namespace {

using xsens::Dialogue;

constexpr Utime kSecond = kMicrosecondsPerSecond;

/// Lets both talk for so long, in steps of 10 ms, a measurement in each.
void talk(Dialogue& dialogue, EmulatedTracker& tracker, Utime& now, Utime how_long) {
  for (const Utime end = now + how_long; now < end; now += kSecond / 100) {
    dialogue.receive(tracker.answer(dialogue.take_output()), now);
    dialogue.receive(tracker.measure(), now);
    dialogue.tick(now);
  }
}

TEST(TrackerDialogue, BothGenerations) {
  for (const bool legacy : {false, true}) {
    Dialogue dialogue({}, 0);
    EmulatedTracker tracker(legacy);
    Utime now = 0;
    talk(dialogue, tracker, now, 2 * kSecond);
    EXPECT_EQ(dialogue.state(), Dialogue::State::measuring) << dialogue.failure();
    EXPECT_EQ(dialogue.info().legacy, legacy);
    EXPECT_EQ(dialogue.info().device_id, 0x0368248CU);
    EXPECT_EQ(dialogue.info().product_code, "MTi-30-2A8G4");
    const auto data = dialogue.take_data();
    ASSERT_GT(data.size(), 100U);
    EXPECT_EQ(data.front().message.mid, legacy ? xsens::kMtData : xsens::kMtData2);
    EXPECT_EQ(data.front().message.data.size(), legacy ? xsens::length_of(dialogue.info().layout) : 31U);
  }
}

TEST(TrackerDialogue, MeasurementsUnderWayWithOldSettingsAreNotTaken) {
  Dialogue dialogue({}, 0);
  EmulatedTracker tracker(true);
  tracker.late_answers = 3;
  Utime now = 0;
  talk(dialogue, tracker, now, 4 * kSecond);
  EXPECT_EQ(dialogue.state(), Dialogue::State::measuring) << dialogue.failure();
  for (const auto& data : dialogue.take_data()) EXPECT_EQ(data.message.data.size(), 54U);
}

TEST(TrackerDialogue, ATrackerThatStartsAnewIsSetUpAnew) {
  Dialogue dialogue({}, 0);
  EmulatedTracker tracker(false);
  Utime now = 0;
  talk(dialogue, tracker, now, kSecond);
  dialogue.take_data();
  dialogue.receive(tracker.reboot(), now);
  EXPECT_EQ(dialogue.state(), Dialogue::State::configuring);
  talk(dialogue, tracker, now, kSecond);
  EXPECT_EQ(dialogue.state(), Dialogue::State::measuring);
  EXPECT_EQ(dialogue.counters().wake_ups, 1U);
  EXPECT_FALSE(dialogue.take_data().empty());
}

TEST(TrackerDialogue, SilenceIsAFailureWithItsReason) {
  Dialogue silent({}, 0);
  for (Utime now = 0; now < 20 * kSecond; now += kSecond / 20) silent.tick(now);
  EXPECT_EQ(silent.failure(), "the tracker does not go to configuration: no answer");
  Dialogue dialogue({}, 0);
  EmulatedTracker tracker(false);
  Utime now = 0;
  talk(dialogue, tracker, now, kSecond);
  for (const Utime end = now + 3 * kSecond; now < end; now += kSecond / 20) dialogue.tick(now);
  EXPECT_EQ(dialogue.failure(), "no measurements for 2 s");
}

TEST(TrackerDialogue, SaysWhatTheTrackerRefuses) {
  Dialogue dialogue({}, 0);
  EmulatedTracker tracker(true);
  tracker.refused = xsens::kSetPeriod;
  Utime now = 0;
  talk(dialogue, tracker, now, 2 * kSecond);
  EXPECT_EQ(dialogue.failure(), "the tracker does not take the period: parameter invalid");
}

}  // namespace
}  // namespace scanway::test
