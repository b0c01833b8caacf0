// scanway-base itself, between LCM's bus on a private network and a test robot on a pseudo-terminal.

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>

#include "bot_core/pose_t.hpp"
#include "scanway/base_command_t.hpp"
#include "tests/modules/base_bridge/plugged_robot.h"
#include "tests/support/bus_peer.h"
#include "tests/support/command.h"
#include "tests/support/private_network.h"
#include "tests/support/program.h"

namespace scanway::test {
namespace {

const std::string kProgram = std::string(SCANWAY_BIN_DIR) + "/scanway-base";

class BaseProgram : public testing::Test {
 protected:
  static void SetUpTestSuite() { private_network = enter_private_network(); }
  void SetUp() override {
    if (!private_network) GTEST_SKIP() << "network namespaces are not permitted here (unshare --net)";
  }
  static inline bool private_network = false;

  const ScratchFolder folder;
  const std::string port = folder / "erratic";
  const std::string err = folder / "err";
  std::string said() const { return read_text(err); }
  int times_said(const std::string& words) const {
    int times = 0;
    const std::string log = said();
    for (std::size_t at = log.find(words); at != log.npos; at = log.find(words, at + 1)) ++times;
    return times;
  }
  bool says(const std::string& words) const { return said().find(words) != std::string::npos; }
};

/// The bus and the program.
struct Bench {
  Bench(const std::string& port, const std::string& err)
      : program({kProgram, "--port", port, "--lcm-url", "udpm://239.255.76.67:7667?ttl=0"}, "/dev/null", err) {
    peer.keep(channel::kOdometry, odometry);
  }
  void command(double speed, double turn_rate = 0) {
    base_command_t message{};
    message.utime = host_now();
    message.forward_speed_m_s = speed;
    message.turn_rate_rad_s = turn_rate;
    peer.say(channel::kBaseCommand, message);
  }
  /// Commands ten times a second until `done`. Returns when the last command was given, 0 if it took too long.
  template <class Done>
  Utime drive_until(double speed, const Done& done, double limit_s = 10) {
    for (const Utime end = host_now() + static_cast<Utime>(limit_s * 1e6); host_now() < end;) {
      const Utime said = host_now();
      command(speed);
      if (peer.listen_until(done, 0.1)) return said;
    }
    return 0;
  }
  bool get_ready() {
    return peer.listen_until([&] { return !odometry.empty(); });
  }

  std::vector<bot_core::pose_t> odometry;
  BusPeer peer;
  Program program;
};

TEST_F(BaseProgram, StandsSoonAfterItsLastCommandAndWhenItEnds) {
  PluggedRobot robot(port);
  Bench bench(port, err);
  ASSERT_TRUE(bench.get_ready()) << said();
  std::vector<Utime> delays;
  for (int i = 0; i < 5; ++i) {
    const auto begun = static_cast<double>(bench.odometry.back().pos[0]);
    const Utime last = bench.drive_until(0.4, [&] { return bench.odometry.back().pos[0] > begun + 0.05; });
    ASSERT_NE(last, 0) << said();
    ASSERT_TRUE(bench.peer.listen_until([&] { return robot.powerless_since() > last; }, 5));
    EXPECT_GE(robot.still_since(), last);
    delays.push_back(robot.powerless_since() - last);
  }
  // The median: this machine may sleep on any one of them.
  std::nth_element(delays.begin(), delays.begin() + 2, delays.end());
  std::printf("stopped and without power: median %.0f ms after the last command\n",
              static_cast<double>(delays[2]) / 1000);
  EXPECT_LE(delays[2], 300'000);
  EXPECT_NEAR(bench.odometry.back().pos[0], robot.with([](TestRobot& r) { return r.x_mm; }) / 1000, 0.002);
  EXPECT_NEAR(bench.odometry.back().orientation[0], 1, 1e-6);
  EXPECT_TRUE(bench.peer.listen_until([&] { return bench.peer.counter("base_bridge", "base_commands") > 5; }, 3));
  EXPECT_EQ(bench.peer.counter("base_bridge", "base_battery_mV"), 12300);
  EXPECT_EQ(bench.peer.counter("base_bridge", "base_commands_refused"), 0);
  EXPECT_EQ(bench.peer.summary("base_bridge"), "");

  ASSERT_NE(bench.drive_until(0.4, [&] { return robot.with([](TestRobot& r) { return r.speed_mm_s == 400; }); }), 0);
  EXPECT_EQ(bench.program.end(SIGTERM), 0) << said();
  usleep(20'000);
  EXPECT_EQ(robot.with([](TestRobot& r) { return r.speed_mm_s; }), 0);
  EXPECT_FALSE(robot.with([](TestRobot& r) { return r.motors_on; }));
}

TEST_F(BaseProgram, ComesBackWhenTheRobotDoes) {
  Bench bench(port, err);
  const auto trouble = [&](const std::string& words) {
    return bench.peer.listen_until([&] { return bench.peer.summary("base_bridge").find(words) != std::string::npos; },
                                   10);
  };
  EXPECT_TRUE(trouble("is the device plugged in")) << said();  // Absent at the start.
  bench.command(0.4);
  EXPECT_TRUE(trouble("is the device plugged in"));
  {
    PluggedRobot robot(port);
    ASSERT_TRUE(bench.get_ready()) << said();
    ASSERT_NE(bench.drive_until(0.4, [&] { return bench.odometry.back().pos[0] > 0.05; }), 0);
  }
  EXPECT_TRUE(trouble("plugged in")) << bench.peer.summary("base_bridge");
  PluggedRobot robot(port);
  bench.odometry.clear();
  ASSERT_TRUE(bench.get_ready()) << said();
  EXPECT_GT(bench.odometry.back().pos[0], 0.04);  // It goes on from where it was.
  EXPECT_EQ(robot.with([](TestRobot& r) { return r.speed_mm_s; }), 0);
  EXPECT_TRUE(bench.peer.listen_until([&] { return bench.peer.counter("base_bridge", "base_times_opened") == 2; }, 3));
  EXPECT_EQ(bench.program.end(SIGTERM), 0);
  EXPECT_EQ(times_said("is the device plugged in"), 2) << said();
  EXPECT_EQ(times_said("there again"), 2) << said();
  EXPECT_EQ(times_said("has restarted"), 1) << said();
}

TEST_F(BaseProgram, NamesAWrongRateAndASecondBridge) {
  PluggedRobot robot(port);
  robot.with([](TestRobot& r) { r.baud = 57600; });
  Bench bench(port, err);
  bench.command(0.1);
  ASSERT_TRUE(bench.peer.listen_until([&] { return says("does not answer at 38400 or 115200 baud"); }, 10)) << said();
  bench.command(0.1);
  EXPECT_TRUE(bench.peer.listen_until([&] { return says("command refused: the base does not answer"); }, 3));
  EXPECT_TRUE(bench.peer.listen_until([&] { return bench.peer.counter("base_bridge", "base_commands_refused") > 0; }));
  const auto second = run_command({kProgram, "--port", "/dev/null", "--lcm-url", "udpm://239.255.76.67:7667?ttl=0"});
  EXPECT_EQ(second.status, 2);
  EXPECT_NE(second.err.find("another base_bridge (process "), std::string::npos) << second.err;
  EXPECT_EQ(bench.program.end(SIGTERM), 0);
}

TEST_F(BaseProgram, ProbeNeedsNoBus) {
  const auto absent = run_command({kProgram, "--probe", "--port", port});
  EXPECT_EQ(absent.status, 2);
  EXPECT_NE(absent.err.find("plugged in"), std::string::npos);
  const auto wrong = run_command({kProgram, "--probe", "--port", "/dev/null"});
  EXPECT_EQ(wrong.status, 2);
  EXPECT_NE(wrong.err.find("/dev/null: this is no serial port"), std::string::npos) << wrong.err;
  PluggedRobot robot(port);
  const auto found = run_command({kProgram, "--probe", "--port", port});
  EXPECT_EQ(found.status, 0) << found.err;
  EXPECT_NE(found.out.find("era-1"), std::string::npos);
  EXPECT_NE(found.out.find("12.3 V"), std::string::npos);
  EXPECT_FALSE(robot.with([](TestRobot& r) { return r.motors_on; }));
}

}  // namespace
}  // namespace scanway::test
