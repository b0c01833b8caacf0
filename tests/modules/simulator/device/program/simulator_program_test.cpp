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

TEST(SimulatorProgram, HearsFaultsOnItsInputAndByOption) {
  if (!enter_private_network()) GTEST_SKIP() << "network namespaces are not permitted here (unshare --net)";
  const ScratchFolder folder;
  const std::string start = "exec '" + std::string(SCANWAY_BIN_DIR) +
                            "/scanway-simulator' --world flat --lms-port 0 --can 'unix:" + (folder / "can") +
                            "' --tracker '" + (folder / "tracker") + "' --base '" + (folder / "base") +
                            "' --lcm-url 'udpm://239.255.76.67:7667?ttl=0' ";
  const auto lived = run_command({"sh", "-c",
                                  "{ sleep 1; echo range-bias=0.1; echo no-such; sleep 1; } | timeout 3 sh -c \"" +
                                      start + "--fault dirty-window=0.8@0+0.5\""});
  EXPECT_NE(lived.err.find("fault slip=0.02"), std::string::npos) << lived.err;
  EXPECT_NE(lived.err.find("fault dirty-window=0.8"), std::string::npos) << lived.err;
  EXPECT_NE(lived.err.find("fault dirty-window has ended"), std::string::npos) << lived.err;
  EXPECT_NE(lived.err.find("fault range-bias=0.1"), std::string::npos) << lived.err;
  EXPECT_NE(lived.err.find("there is no such fault"), std::string::npos) << lived.err;
  const auto refused = run_command({"sh", "-c", start + "--fault nonsense"});
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.err.find("there is no such fault"), std::string::npos) << refused.err;
}

}  // namespace
}  // namespace scanway::test
