#include "modules/schunk_bridge/core/pan_tilt.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/modules/schunk_bridge/core/bench_of_two.h"

namespace scanway {
namespace {

using schunk::Axis;
using schunk::Event;
using test::BenchOfTwo;
using test::TestModule;

class InEveryUnit : public testing::TestWithParam<TestModule::Units> {};

TEST_P(InEveryUnit, FindsItsModulesAndKnowsWhereTheyAre) {
  BenchOfTwo bench(GetParam());
  ASSERT_TRUE(bench.get_ready());
  EXPECT_NEAR(bench.bridge.pan().state()->position, radians(10), 1e-6);
  EXPECT_NEAR(bench.bridge.pan().high(), radians(400), 1e-5);    // The module's own limit is closer.
  EXPECT_NEAR(bench.bridge.tilt().high(), radians(120), 1e-12);  // The configuration's is.
  EXPECT_TRUE(bench.find(Event::Kind::found, "pan")->text.find("PW-70") != std::string::npos);
}

TEST_P(InEveryUnit, GoesWhereItIsSent) {
  BenchOfTwo bench(GetParam());
  ASSERT_TRUE(bench.get_ready());
  ASSERT_EQ(bench.bridge.move_pan(radians(90), radians(40), bench.now), "");
  ASSERT_TRUE(bench.run_until([&] { return bench.find(Event::Kind::reached, "pan") != nullptr; }, 5));
  EXPECT_NEAR(bench.pan.angle(), 90, 1e-3);
  EXPECT_NEAR(bench.pan.speed(), 40, 1e-3);
}

INSTANTIATE_TEST_SUITE_P(Units, InEveryUnit,
                         testing::Values(TestModule::kRadians, TestModule::kDegrees, TestModule::kMillidegrees));

TEST(PanTilt, LeavesAMillisecondBetweenFrames) {
  BenchOfTwo bench;
  ASSERT_TRUE(bench.get_ready());
  ASSERT_GT(bench.sent.size(), 10u);
  for (std::size_t i = 1; i < bench.sent.size(); ++i) {
    EXPECT_GE(bench.sent[i].utime - bench.sent[i - 1].utime, 1000);
  }
}

TEST(PanTilt, MovesNothingUnasked) {
  BenchOfTwo bench(TestModule::kDegrees, false);
  bench.run(5);
  for (const TestModule* module : {&bench.pan, &bench.tilt}) {
    for (const std::uint8_t command : module->commands) EXPECT_TRUE(command == 0x80 || command == 0x95) << +command;
  }
}

TEST(PanTilt, DoesWithoutAnnouncements) {
  BenchOfTwo bench;
  bench.pan.impulses = bench.tilt.impulses = false;
  ASSERT_TRUE(bench.get_ready());
  ASSERT_EQ(bench.bridge.move_tilt(radians(30), radians(20), bench.now), "");
  EXPECT_TRUE(bench.run_until([&] { return bench.find(Event::Kind::reached, "tilt") != nullptr; }, 5));
}

TEST(PanTilt, StopIsTheNextFrameOnTheWire) {
  BenchOfTwo bench;
  ASSERT_TRUE(bench.get_ready());
  ASSERT_EQ(bench.bridge.start_sweep(bench.now), "");
  ASSERT_TRUE(bench.run_until([&] { return bench.bridge.sweep().scanning() && bench.pan.moving(); }));
  bench.run(1);
  const std::size_t before = bench.sent.size();
  const Utime asked = bench.now;
  bench.bridge.stop(bench.now);
  bench.run(0.02);
  ASSERT_GE(bench.sent.size(), before + 2);
  for (std::size_t i = before; i < before + 2; ++i) {
    EXPECT_EQ(bench.sent[i].frame.data[1], 0x91);
    EXPECT_LE(bench.sent[i].utime - asked, 20'000);
  }
  EXPECT_NE(bench.sent[before].frame.id, bench.sent[before + 1].frame.id);  // One an axis.
  EXPECT_FALSE(bench.pan.moving());
  EXPECT_NE(bench.find(Event::Kind::sweep_aborted), nullptr);
  bench.run(1);
  EXPECT_FALSE(bench.pan.moving());
}

TEST(PanTilt, StopsWhateverTheModulesDoNotSay) {
  BenchOfTwo bench;
  bench.pan.powered = bench.tilt.powered = false;
  bench.run(3);
  bench.sent.clear();
  bench.bridge.stop(bench.now);
  bench.run(0.02);
  ASSERT_GE(bench.sent.size(), 2u);
  EXPECT_EQ(bench.sent[0].frame.data[1], 0x91);
  EXPECT_EQ(bench.sent[1].frame.data[1], 0x91);
}

TEST(PanTilt, FastStopHoldsUntilAcknowledged) {
  BenchOfTwo bench;
  ASSERT_TRUE(bench.get_ready());
  ASSERT_EQ(bench.bridge.move_pan(radians(90), radians(10), bench.now), "");
  bench.run(0.5);
  bench.bridge.fast_stop(bench.now);
  bench.run(0.1);
  EXPECT_EQ(bench.pan.error(), 0xD9);
  EXPECT_EQ(bench.bridge.pan().error(), 0xD9);
  EXPECT_NE(bench.bridge.move_pan(0, radians(10), bench.now).find("FAST STOP"), std::string::npos);
  EXPECT_NE(bench.bridge.start_sweep(bench.now), "");
  EXPECT_EQ(bench.bridge.acknowledge(), "");
  bench.run(0.1);
  EXPECT_EQ(bench.bridge.pan().error(), 0);
  EXPECT_NE(bench.find(Event::Kind::cleared, "pan"), nullptr);
  EXPECT_EQ(bench.bridge.move_pan(0, radians(10), bench.now), "");
}

TEST(PanTilt, SaysWhichCommandWasRefusedAndWhy) {
  BenchOfTwo bench;
  ASSERT_TRUE(bench.get_ready());
  bench.pan.refuses_moves = true;
  ASSERT_EQ(bench.bridge.move_pan(radians(20), radians(10), bench.now), "");
  bench.run(0.1);
  ASSERT_NE(bench.find(Event::Kind::refused, "pan"), nullptr);
  EXPECT_NE(bench.find(Event::Kind::refused, "pan")->text.find("MOVE POS with 05 FAILED"), std::string::npos);
  EXPECT_FALSE(bench.bridge.pan().motion().under_way());
}

TEST(PanTilt, KeepsWithinTheLimits) {
  BenchOfTwo bench;
  ASSERT_TRUE(bench.get_ready());
  EXPECT_NE(bench.bridge.move_pan(radians(401), radians(10), bench.now).find("limits"), std::string::npos);
  EXPECT_NE(bench.bridge.move_tilt(radians(-121), radians(10), bench.now).find("limits"), std::string::npos);
  EXPECT_NE(bench.bridge.move_pan(0, radians(121), bench.now).find("121.00 deg/s"), std::string::npos);
  EXPECT_NE(bench.bridge.move_pan(std::nan(""), radians(10), bench.now), "");
  EXPECT_NE(bench.bridge.move_pan(0, 0, bench.now), "");
  bench.run(0.1);
  EXPECT_TRUE(bench.pan.move_targets.empty());
}

TEST(PanTilt, ComesBackAfterASilenceAndAfterARestart) {
  BenchOfTwo bench;
  ASSERT_TRUE(bench.get_ready());
  bench.pan.powered = false;
  ASSERT_TRUE(bench.run_until([&] { return bench.find(Event::Kind::lost, "pan") != nullptr; }, 2));
  EXPECT_EQ(bench.bridge.tilt().phase(), Axis::Phase::ready);  // The other goes on.
  EXPECT_NE(bench.bridge.move_pan(0, radians(10), bench.now), "");
  bench.run(20);
  EXPECT_EQ(std::count_if(bench.events.begin(), bench.events.end(),
                          [](const Event& event) { return event.kind == Event::Kind::lost; }),
            1);  // Said once.
  bench.pan.powered = true;
  ASSERT_TRUE(bench.get_ready());
  bench.events.clear();
  bench.deliver(bench.pan.reboot(bench.now));
  ASSERT_TRUE(bench.run_until([&] { return bench.find(Event::Kind::found, "pan") != nullptr; }, 3));
  EXPECT_NE(bench.find(Event::Kind::booted, "pan"), nullptr);
  EXPECT_FALSE(bench.bridge.pan().referenced());
}

TEST(PanTilt, SaysOnceThatNobodyAnswers) {
  BenchOfTwo bench;
  bench.pan.powered = bench.tilt.powered = false;
  bench.run(10);
  ASSERT_EQ(bench.events.size(), 2u);
  EXPECT_NE(bench.events[0].text.find("module 11"), std::string::npos);
  EXPECT_NE(bench.events[0].text.find("bit rate"), std::string::npos);
  bench.pan.powered = bench.tilt.powered = true;
  EXPECT_TRUE(bench.get_ready());
}

TEST(PanTilt, RefusesAModuleThatCountsInMillimetres) {
  BenchOfTwo bench(TestModule::kMillimetres);
  bench.run(12);
  EXPECT_EQ(bench.bridge.pan().phase(), Axis::Phase::unusable);
  ASSERT_EQ(bench.events.size(), 2u);
  EXPECT_NE(bench.events[0].text.find("'mm'"), std::string::npos);
}

TEST(PanTilt, RefusesTwoAxesOfOneId) {
  schunk::PanTiltConfig config;
  config.tilt.module = config.pan.module;
  EXPECT_THROW(schunk::PanTilt bridge(config), std::invalid_argument);
}

TEST(PanTilt, SurvivesAStopDuringItsSetUp) {
  for (int milliseconds = 1; milliseconds < 40; ++milliseconds) {
    BenchOfTwo bench;
    bench.run(milliseconds / 1000.0);
    bench.bridge.stop(bench.now);
    ASSERT_TRUE(bench.get_ready()) << milliseconds;
  }
}

}  // namespace
}  // namespace scanway
