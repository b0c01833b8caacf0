// scanway-simulator itself, and the bridge's device on its laser.
#include <filesystem>

#include <gtest/gtest.h>

#include "common/clock/steady_time.h"
#include "modules/sick_bridge/device/lms_device.h"
#include "tests/support/command.h"
#include "tests/support/private_network.h"
#include "tests/support/program.h"

namespace scanway::test {
namespace {

TEST(SimulatorProgram, ServesItsDevicesAndLeavesNothingBehind) {
  if (!enter_private_network()) GTEST_SKIP() << "network namespaces are not permitted here (unshare --net)";
  const ScratchFolder folder;
  const std::string can = folder / "can", tracker = folder / "tracker", base = folder / "base", out = folder / "out";
  Program program({std::string(SCANWAY_BIN_DIR) + "/scanway-simulator", "--world", "flat", "--seed", "3", "--lms-port",
                   "2112", "--can", "unix:" + can, "--tracker", tracker, "--base", base, "--thin", "8", "--lcm-url",
                   "udpm://239.255.76.67:7667?ttl=0"},
                  out, folder / "err");
  sick::LmsDevice lms({"127.0.0.1", 2112}, {});
  std::size_t scans = 0;
  for (const Utime limit = steady_now() + 20 * kMicrosecondsPerSecond; scans < 3 && steady_now() < limit;) {
    scans += lms.run(5).scans.size();
  }
  EXPECT_GE(scans, 3U) << read_text(folder / "err");
  EXPECT_TRUE(std::filesystem::is_symlink(tracker) && std::filesystem::is_symlink(base));
  EXPECT_NE(read_text(out).find("laser    127.0.0.1:2112\n"), std::string::npos);
  EXPECT_EQ(program.end(), 0);
  EXPECT_FALSE(std::filesystem::exists(can) || std::filesystem::is_symlink(tracker));
}

}  // namespace
}  // namespace scanway::test
