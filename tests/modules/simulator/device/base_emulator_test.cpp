#include "modules/simulator/device/base/base_emulator.h"

#include <cmath>

#include "common/clock/steady_time.h"
#include "modules/base_bridge/device/base_driver.h"
#include "modules/simulator/device/ends/terminal_end.h"
#include "tests/modules/simulator/device/shared_facts.h"

namespace scanway::test {
namespace {

using namespace simulator;

std::span<const std::uint8_t> bytes_of(const std::string& text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

TEST(BasePacket, TheSheetsVectorsByteForByte) {
  SKIP_WITHOUT_FACTS();
  const auto vectors = facts_json("erratic/vectors.json");
  const auto named = [&](const char* name) { return hex_of(vector_named(vectors, name)); };
  const auto hex = [](const BaseBytes& bytes) { return hex_of(text_of(bytes)); };
  EXPECT_EQ(hex(configuration_packet("era-1", "Erratic", "Rev H")), named("config_reply_rev_h"));
  EXPECT_EQ(hex(motor_packet({})), named("motor_stopped_zero"));
  MotorCounts forward{true, 100, 0, 0, 166, 166, 122};
  EXPECT_EQ(hex(motor_packet(forward)), named("motor_moving_forward"));
  MotorCounts left{true, 100, 0, 1024, -83, 83, 122, false, false, 1024};
  EXPECT_EQ(hex(motor_packet(left)), named("motor_turning_left"));
  MotorCounts right{true, 4090, 4000, -512, -166, -166, 121, false, false, -512};
  EXPECT_EQ(hex(motor_packet(right)), named("motor_negative_heading"));
  MotorCounts stalled{false, 2048, 7, 0, 0, 0, 119, true, true};
  EXPECT_EQ(hex(motor_packet(stalled)), named("motor_stalled"));
}

TEST(BaseEmulator, ObeysTheSheetsCommands) {
  SKIP_WITHOUT_FACTS();
  const auto vectors = facts_json("erratic/vectors.json");
  BaseEmulator base;
  const auto send = [&](const char* name, Utime now) {
    return hex_of(text_of(base.receive(bytes_of(vector_named(vectors, name)), now)));
  };
  EXPECT_EQ(send("configuration_request", 0), hex_of(vector_named(vectors, "config_reply_rev_h")));
  EXPECT_TRUE(base.tick(100'000).empty()) << "silent until it is opened";
  send("open_controller", 100'000);
  EXPECT_EQ(hex_of(text_of(base.tick(100'000))), hex_of(vector_named(vectors, "motor_stopped_zero")));
  send("trans_vel_200", 100'000);
  base.tick(1'000'000);
  EXPECT_EQ(base.motion().x_mm, 0.0) << "no power on the motors";
  send("enable_motors_1", 1'000'000);
  base.tick(2'000'000);
  // A fifth of a second to get there, and the rest at 200 mm/s.
  EXPECT_NEAR(base.motion().x_mm, 0.5 * 0.2 * 200 + 0.8 * 200, 1.5);
  send("rot_vel_m30", 2'000'000);
  base.tick(3'000'000);
  EXPECT_LT(base.motion().heading, -0.4);
  send("stop", 3'000'000);
  const double x = base.motion().x_mm;
  base.tick(4'000'000);
  EXPECT_EQ(base.motion().x_mm, x);
  send("wheel_vel_left_m200_right200", 4'000'000);
  base.tick(5'000'000);
  EXPECT_NEAR(base.motion().turn_rate_rad_s, 400 / 305.07, 1e-3);
}

TEST(BaseEmulator, StandsWhenItHearsNothingForTooLong) {
  SKIP_WITHOUT_FACTS();
  const auto vectors = facts_json("erratic/vectors.json");
  BaseEmulatorConfig config;
  config.watchdog = 2 * kMicrosecondsPerSecond;
  BaseEmulator base(config);
  for (const char* name : {"open_controller", "enable_motors_1", "trans_vel_200"}) {
    base.receive(bytes_of(vector_named(vectors, name)), 0);
  }
  for (Utime now = 0; now <= 1'900'000; now += 100'000) base.tick(now);
  EXPECT_EQ(base.motion().speed_mm_s, 200.0);
  for (Utime now = 1'900'000; now <= 3'000'000; now += 100'000) base.tick(now);
  EXPECT_EQ(base.motion().speed_mm_s, 0.0);
}

TEST(BaseEmulator, TheBridgesOdometryFollowsADrive) {
  ScratchFolder folder;
  TerminalEnd end(folder / "base");
  BaseEmulator base;
  erratic::BaseDriver driver(end.link(), {});
  const Utime began = steady_now();
  const auto run_until = [&](const auto& done) {
    for (const Utime limit = steady_now() + 20 * kMicrosecondsPerSecond; steady_now() < limit;) {
      const Utime now = steady_now() - began;
      // A robot hears nothing at another rate than its own.
      if (const auto bytes = end.hear(); end.baud() == 38400) end.say(base.receive(bytes, now));
      end.say(base.tick(now));
      driver.step(1);
      if (done()) return true;
    }
    return false;
  };
  ASSERT_TRUE(run_until([&] { return driver.core().ready(); }));
  const Utime drive_ends = steady_now() + 1'500'000;
  ASSERT_TRUE(run_until([&] {
    EXPECT_EQ(driver.core().drive(0.5, 0.6, driver.now()), "");
    return steady_now() > drive_ends;
  }));
  driver.core().stop(driver.now());
  const auto stands = [&] { return base.motion().speed_mm_s == 0.0 && driver.core().pose().speed_m_s == 0.0; };
  ASSERT_TRUE(run_until(stands));
  const Utime settled = steady_now() + 150'000;
  run_until([&] { return steady_now() > settled; });
  EXPECT_GT(base.motion().x_mm, 400.0);
  EXPECT_GT(base.motion().heading, 0.5);
  EXPECT_NEAR(driver.core().pose().x_m, base.motion().x_mm * 1e-3, 0.002);
  EXPECT_NEAR(driver.core().pose().y_m, base.motion().y_mm * 1e-3, 0.002);
  EXPECT_NEAR(driver.core().pose().heading, base.motion().heading, 0.002);
  EXPECT_EQ(driver.core().counters().bad_bytes + driver.core().counters().malformed, 0U);
  base.block(true);
  EXPECT_EQ(driver.core().drive(0.2, 0.0, driver.now()), "");
  EXPECT_TRUE(run_until([&] { return driver.core().stalled(); }));
}

}  // namespace
}  // namespace scanway::test
