// The bridge's device against a test robot on a pseudo-terminal.

#include "modules/base_bridge/device/base_driver.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include "common/files/input_error.h"
#include "tests/modules/base_bridge/plugged_robot.h"
#include "tests/support/command.h"

namespace scanway {
namespace {

using erratic::BaseDriver;
using test::PluggedRobot;

struct Bench {
  template <class Done>
  bool run_until(const Done& done, double limit_s = 10) {
    for (const Utime end = BaseDriver::now() + static_cast<Utime>(limit_s * 1e6); BaseDriver::now() < end;) {
      driver.step(5);
      for (auto& line : driver.take_troubles()) troubles.push_back(std::move(line));
      if (done()) return true;
    }
    return false;
  }
  bool get_ready() {
    return run_until([&] { return driver.core().ready(); });
  }

  test::ScratchFolder folder;
  std::string port = folder / "erratic";
  BaseDriver driver{port, {}};
  std::vector<std::string> troubles;
};

TEST(BaseDriver, DrivesARobotOnASerialPort) {
  Bench bench;
  PluggedRobot robot(bench.port);
  ASSERT_TRUE(bench.get_ready());
  ASSERT_TRUE(bench.run_until([&] {
    bench.driver.core().drive(0.4, 0, BaseDriver::now());
    return bench.driver.core().pose().x_m > 0.05;
  }));
  // And without commands it is told to stand.
  EXPECT_TRUE(bench.run_until(
      [&] { return robot.with([](test::TestRobot& r) { return r.speed_mm_s == 0 && !r.motors_on; }); }, 5));
}

TEST(BaseDriver, FindsTheOtherBaudRate) {
  Bench bench;
  PluggedRobot robot(bench.port);
  robot.with([](test::TestRobot& r) { r.baud = 115200; });
  ASSERT_TRUE(bench.get_ready());
  EXPECT_EQ(bench.driver.core().baud(), 115200);
}

TEST(BaseDriver, ComesBackWhenThePortDoes) {
  Bench bench;
  bench.run_until([] { return false; }, 0.2);
  ASSERT_EQ(bench.troubles.size(), 1u);  // Absent at the start.
  EXPECT_NE(bench.troubles[0].find("is the device plugged in"), std::string::npos);
  {
    PluggedRobot robot(bench.port);
    ASSERT_TRUE(bench.get_ready());
  }
  EXPECT_TRUE(bench.run_until([&] { return bench.troubles.size() == 4; }, 3));  // There, gone, and not to be opened.
  PluggedRobot robot(bench.port);
  ASSERT_TRUE(bench.run_until([&] { return robot.with([](test::TestRobot& r) { return !r.commands.empty(); }); }));
  EXPECT_TRUE(bench.get_ready());
}

TEST(BaseDriver, LeavesTheRobotStanding) {
  Bench outer;
  PluggedRobot robot(outer.port);
  {
    BaseDriver driver(outer.port, {});
    for (const Utime end = BaseDriver::now() + 5'000'000; BaseDriver::now() < end;) {
      driver.step(5);
      driver.core().drive(0.4, 0, BaseDriver::now());
      if (robot.with([](test::TestRobot& r) { return r.speed_mm_s; }) == 400) break;
    }
  }
  for (int i = 0; i < 1000 && robot.with([](test::TestRobot& r) { return r.motors_on; }); ++i) usleep(1000);
  EXPECT_EQ(robot.with([](test::TestRobot& r) { return r.speed_mm_s; }), 0);
  EXPECT_FALSE(robot.with([](test::TestRobot& r) { return r.motors_on; }));
  EXPECT_EQ(robot.with([](test::TestRobot& r) { return r.commands.back(); }), 2);
}

TEST(BaseDriver, NamesWhatIsWrongWithAPort) {
  const auto words = [](const std::string& path, int baud = 38400) {
    try {
      SerialPort port(path, baud);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  const test::ScratchFolder folder;
  EXPECT_NE(words(folder / "nothing").find("plugged in"), std::string::npos);
  EXPECT_NE(words("/dev/null").find("no serial port"), std::string::npos);
  PluggedRobot robot(folder / "port");
  EXPECT_NE(words(folder / "port", 12345).find("12345 baud"), std::string::npos);
  const SerialPort first(folder / "port", 38400);
  EXPECT_NE(words(folder / "port").find("another program uses it"), std::string::npos);
}

TEST(BaseDriver, ProbeSaysWhatIsThere) {
  const test::ScratchFolder folder;
  PluggedRobot robot(folder / "port");
  const auto found = erratic::probe(folder / "port");
  EXPECT_TRUE(found.works);
  const auto& lines = found.lines;
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_NE(lines[0].find("era-1"), std::string::npos);
  EXPECT_NE(lines[1].find("12.3 V"), std::string::npos);
  EXPECT_THROW(erratic::probe(folder / "nothing"), InputError);
}

}  // namespace
}  // namespace scanway
