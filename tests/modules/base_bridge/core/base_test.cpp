#include "modules/base_bridge/core/base.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/modules/base_bridge/core/bench.h"

namespace scanway {
namespace {

using test::Bench;
using Kind = erratic::BaseEvent::Kind;

TEST(Base, FindsTheRobotAtEitherBaudRate) {
  for (const int baud : {38400, 115200}) {
    Bench bench(baud);
    ASSERT_TRUE(bench.get_ready()) << baud;
    EXPECT_EQ(bench.base.baud(), baud);
    ASSERT_EQ(bench.count(Kind::found), 1);
    EXPECT_NE(bench.events[0].text.find("era-1, Erratic Rev H"), std::string::npos);
  }
}

TEST(Base, LeavesTheRobotTimeBetweenPackets) {
  Bench bench;
  ASSERT_TRUE(bench.get_ready());
  for (int i = 0; i < 20; ++i) {
    bench.base.drive(0.01 * i, 0, bench.now);
    bench.run(0.02);
  }
  for (std::size_t i = 1; i < bench.sent.size(); ++i) EXPECT_GE(bench.sent[i] - bench.sent[i - 1], 15'000);
}

TEST(Base, StopsTheRobotBeforeAnythingElse) {
  Bench bench;
  bench.robot.motors_on = true;
  bench.robot.speed_mm_s = 500;  // Whoever drove it is gone.
  ASSERT_TRUE(bench.get_ready());
  bench.run(0.2);
  EXPECT_EQ(bench.robot.speed_mm_s, 0);
  EXPECT_FALSE(bench.robot.motors_on);
}

TEST(Base, DrivesWithItsMotorsOnAsLongAsItIsTold) {
  Bench bench;
  ASSERT_TRUE(bench.get_ready());
  for (int i = 0; i < 40; ++i) {
    ASSERT_EQ(bench.base.drive(0.5, radians(-20), bench.now), "");
    bench.run(0.1);
  }
  EXPECT_TRUE(bench.robot.motors_on);
  EXPECT_EQ(bench.robot.speed_mm_s, 500);
  EXPECT_EQ(bench.robot.turn_deg_s, -20);
  EXPECT_EQ(bench.count(Kind::motors_off), 0);
}

TEST(Base, MotorsAreOffWithin300MillisecondsOfTheLastCommand) {
  // Whatever the phase between the command and everything periodic.
  for (int phase = 0; phase < 120; ++phase) {
    Bench bench;
    ASSERT_TRUE(bench.get_ready());
    for (int i = 0; i < 10; ++i) {
      bench.base.drive(1.0, 0, bench.now);
      bench.run(0.09);
    }
    bench.run(phase / 1000.0);
    bench.base.drive(1.0, 0.1, bench.now);
    const Utime last = bench.now;
    while (bench.robot.speed_mm_s != 0 || bench.robot.motors_on || bench.now == last) {
      bench.step();
      ASSERT_LE(bench.now - last, 300'000) << phase;
    }
    bench.run(1);
    EXPECT_EQ(bench.robot.speed_mm_s, 0);
    EXPECT_FALSE(bench.robot.motors_on);
    EXPECT_GE(bench.count(Kind::motors_off), 1);
  }
}

TEST(Base, StopsAtOnceWhenToldTo) {
  Bench bench;
  ASSERT_TRUE(bench.get_ready());
  bench.base.drive(1.0, 0, bench.now);
  bench.run(0.1);
  ASSERT_EQ(bench.robot.speed_mm_s, 1000);
  bench.base.stop(bench.now);
  bench.run(0.02);
  EXPECT_EQ(bench.robot.speed_mm_s, 0);
}

TEST(Base, KeepsTheCurveOfACommandThatIsTooFast) {
  Bench bench;
  ASSERT_TRUE(bench.get_ready());
  bench.run(0.1);
  bench.base.drive(4.0, radians(100), bench.now);
  bench.run(0.1);
  EXPECT_EQ(bench.robot.speed_mm_s, 2000);
  EXPECT_EQ(bench.robot.turn_deg_s, 50);
}

TEST(Base, StopsForASpeedThatIsNoNumber) {
  Bench bench;
  ASSERT_TRUE(bench.get_ready());
  bench.base.drive(1.0, 0, bench.now);
  bench.run(0.1);
  EXPECT_NE(bench.base.drive(std::numeric_limits<double>::quiet_NaN(), 0, bench.now), "");
  bench.run(0.02);
  EXPECT_EQ(bench.robot.speed_mm_s, 0);
}

TEST(Base, FollowsTheRobotAcrossManyWraps) {
  Bench bench;
  ASSERT_TRUE(bench.get_ready());
  for (int i = 0; i < 600; ++i) {  // 60 s; a counter wraps every 3.8 m.
    bench.base.drive(i < 300 ? 1.2 : -0.8, radians(i % 100 < 50 ? 20 : -10), bench.now);
    bench.run(0.1);
  }
  EXPECT_NEAR(bench.base.pose().x_m, bench.robot.x_mm / 1000, 0.002);
  EXPECT_NEAR(bench.base.pose().y_m, bench.robot.y_mm / 1000, 0.002);
  EXPECT_GT(std::abs(bench.robot.x_mm) + std::abs(bench.robot.y_mm), 4000);
  EXPECT_EQ(bench.base.counters().dropped_steps, 0u);
}

TEST(Base, ComesBackAfterARestartAndGoesOnFromWhereItWas) {
  Bench bench;
  ASSERT_TRUE(bench.get_ready());
  for (int i = 0; i < 30; ++i) {
    bench.base.drive(0.5, radians(30), bench.now);
    bench.run(0.1);
  }
  bench.run(1);
  const erratic::WheelPose before = bench.base.pose();
  bench.robot.reboot();
  bench.run(0.5);
  ASSERT_TRUE(bench.count(Kind::lost) == 0);
  bench.run(6);
  ASSERT_TRUE(bench.base.ready());
  EXPECT_EQ(bench.count(Kind::lost), 1);
  EXPECT_EQ(bench.count(Kind::found), 2);
  EXPECT_NEAR(bench.base.pose().x_m, before.x_m, 1e-9);
  EXPECT_NEAR(bench.base.pose().heading, before.heading, 1e-9);
  bench.base.drive(0.5, 0, bench.now);
  bench.run(1);
  // On along the heading that it had, not along the robot's new x axis.
  const double along = (bench.base.pose().x_m - before.x_m) * std::cos(before.heading) +
                       (bench.base.pose().y_m - before.y_m) * std::sin(before.heading);
  const double across = (bench.base.pose().y_m - before.y_m) * std::cos(before.heading) -
                        (bench.base.pose().x_m - before.x_m) * std::sin(before.heading);
  EXPECT_GT(along, 0.05);
  EXPECT_NEAR(across, 0, 0.002);
}

TEST(Base, SaysOnceThatNobodyAnswers) {
  Bench bench;
  bench.robot.powered = false;
  bench.run(20);
  ASSERT_EQ(bench.events.size(), 1u);
  EXPECT_NE(bench.events[0].text.find("does not answer at 38400 or 115200"), std::string::npos);
  EXPECT_NE(bench.base.drive(1, 0, bench.now), "");
  bench.robot.powered = true;
  EXPECT_TRUE(bench.get_ready());
}

TEST(Base, SaysThatSomethingElseTalks) {
  Bench bench;
  bench.robot.powered = false;
  for (int i = 0; i < 4000; ++i) {
    const std::uint8_t noise[] = {0x24, 0x47, 0x50, 0xFA};
    bench.base.receive(noise, bench.now);
    bench.step();
  }
  ASSERT_EQ(bench.events.size(), 1u);
  EXPECT_NE(bench.events[0].text.find("right port"), std::string::npos);
}

TEST(Base, StopsARobotThatIsNotHeardAnyMore) {
  Bench bench;
  ASSERT_TRUE(bench.get_ready());
  // The line from the robot breaks; the one to it does not.
  for (int i = 0; i < 40; ++i) {
    bench.base.drive(1.0, 0, bench.now);
    for (int k = 0; k < 100; ++k) {
      bench.base.tick(bench.now);
      for (auto packet = bench.base.next_packet(bench.now); !packet.empty();
           packet = bench.base.next_packet(bench.now)) {
        bench.robot.receive(packet, bench.base.baud());
      }
      bench.now += 1000;
    }
  }
  EXPECT_EQ(bench.robot.speed_mm_s, 0);
  EXPECT_FALSE(bench.robot.motors_on);
}

TEST(Base, SaysOnceThatAWheelIsStalled) {
  Bench bench;
  ASSERT_TRUE(bench.get_ready());
  bench.robot.stalled = true;
  bench.run(1);
  EXPECT_EQ(bench.count(Kind::stalled), 1);
}

}  // namespace
}  // namespace scanway
