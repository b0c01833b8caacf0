#include "modules/schunk_bridge/core/sweep.h"

#include <gtest/gtest.h>

#include "tests/modules/schunk_bridge/core/bench_of_two.h"

namespace scanway {
namespace {

using schunk::Event;
using test::BenchOfTwo;
using test::TestModule;

TEST(Sweep, SweepsOnceAroundAndBackWithItsEndsMarked) {
  schunk::PanTiltConfig config;
  config.sweep.speed = radians(30);
  config.sweep.tilt = radians(-5);
  BenchOfTwo bench(TestModule::kDegrees, false, config);  // Not referenced: the one command does that as well.
  ASSERT_TRUE(bench.get_ready());
  ASSERT_EQ(bench.bridge.start_sweep(bench.now), "");
  EXPECT_NE(bench.bridge.start_sweep(bench.now), "");
  ASSERT_TRUE(bench.run_until([&] { return bench.find(Event::Kind::sweep_done) != nullptr; }));
  const Event* start = bench.find(Event::Kind::sweep_started);
  const Event* end = bench.find(Event::Kind::sweep_ended);
  ASSERT_TRUE(start && end);
  EXPECT_NEAR(start->position, radians(-180), radians(0.25));
  EXPECT_NEAR(end->position, radians(180), radians(0.01));
  EXPECT_NEAR(to_seconds(end->utime - start->utime), 12.0, 0.1);
  EXPECT_EQ(bench.pan.move_targets, (std::vector<double>{-180, 180, -180}));
  EXPECT_NEAR(bench.pan.angle(), -180, 1e-3);
  EXPECT_NEAR(bench.tilt.angle(), -5, 1e-3);
  EXPECT_EQ(bench.find(Event::Kind::sweep_aborted), nullptr);
  ASSERT_EQ(bench.bridge.start_sweep(bench.now), "");
  EXPECT_EQ(bench.bridge.sweep().number(), 2);
}

TEST(Sweep, TakesThreeDegreesASecondUnlessTold) {
  BenchOfTwo bench;
  ASSERT_TRUE(bench.get_ready());
  ASSERT_EQ(bench.bridge.start_sweep(bench.now), "");
  ASSERT_TRUE(bench.run_until([&] { return bench.find(Event::Kind::sweep_ended) != nullptr; }));
  EXPECT_NEAR(to_seconds(bench.find(Event::Kind::sweep_ended)->utime - bench.find(Event::Kind::sweep_started)->utime),
              120, 0.1);
}

TEST(Sweep, NamesAnErrorAndGivesTheSweepUp) {
  BenchOfTwo bench;
  ASSERT_TRUE(bench.get_ready());
  ASSERT_EQ(bench.bridge.start_sweep(bench.now), "");
  ASSERT_TRUE(bench.run_until([&] { return bench.find(Event::Kind::sweep_started) != nullptr; }));
  bench.deliver(bench.tilt.fail(0xDA));
  bench.run(0.1);
  const Event* error = bench.find(Event::Kind::error, "tilt");
  ASSERT_NE(error, nullptr);
  EXPECT_EQ(error->code, 0xDA);
  EXPECT_NE(error->text.find("DA TOW"), std::string::npos);
  EXPECT_NE(bench.find(Event::Kind::sweep_aborted), nullptr);
  EXPECT_FALSE(bench.pan.moving());  // The healthy axis does not go on alone.
}

TEST(Sweep, NoticesThatAnAxisIsStuckOrBlocked) {
  for (const bool stuck : {true, false}) {
    BenchOfTwo bench;
    ASSERT_TRUE(bench.get_ready());
    ASSERT_EQ(bench.bridge.start_sweep(bench.now), "");
    ASSERT_TRUE(bench.run_until([&] { return bench.find(Event::Kind::sweep_started) != nullptr; }));
    (stuck ? bench.pan.stuck : bench.pan.blocked) = true;
    ASSERT_TRUE(bench.run_until([&] { return bench.find(Event::Kind::sweep_aborted) != nullptr; }, 5)) << stuck;
    EXPECT_NE(bench.find(Event::Kind::blocked, "pan"), nullptr);
    EXPECT_EQ(bench.find(Event::Kind::sweep_ended), nullptr);
  }
}

TEST(Sweep, GivesTheSweepUpWhenTheTiltSlips) {
  BenchOfTwo bench;
  ASSERT_TRUE(bench.get_ready());
  ASSERT_EQ(bench.bridge.start_sweep(bench.now), "");
  ASSERT_TRUE(bench.run_until([&] { return bench.find(Event::Kind::sweep_started) != nullptr; }));
  bench.tilt.tilt_by(1.0);
  EXPECT_TRUE(bench.run_until([&] { return bench.find(Event::Kind::sweep_aborted) != nullptr; }, 1));
}

}  // namespace
}  // namespace scanway
