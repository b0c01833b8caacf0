// scanway-xsens itself, between LCM's bus on a private network and an emulated tracker on a pseudo-terminal.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <optional>
#include <thread>

#include "bot_core/ins_t.hpp"
#include "tests/modules/xsens_bridge/terminal_tracker.h"
#include "tests/support/bus_peer.h"
#include "tests/support/command.h"
#include "tests/support/private_network.h"
#include "tests/support/program.h"
#include "tests/support/refusals.h"

namespace scanway::test {
namespace {

const std::string kProgram = std::string(SCANWAY_BIN_DIR) + "/scanway-xsens";

class XsensProgram : public testing::Test {
 protected:
  static void SetUpTestSuite() { private_network = enter_private_network(); }
  void SetUp() override {
    if (!private_network) GTEST_SKIP() << "network namespaces are not permitted here (unshare --net)";
  }
  void plug_in() {
    tracker_.emplace(false);
    std::filesystem::create_symlink(tracker_->path(), port_);
  }
  void unplug() {
    tracker_.reset();
    std::filesystem::remove(port_);
  }
  /// Runs the tracker, if there is one, and listens to the bus until `done`.
  template <class Done>
  bool run_until(BusPeer& peer, const Done& done) {
    return peer.listen_until([&] {
      if (tracker_) tracker_->run();
      return done();
    });
  }
  std::string said() const { return read_text(err_); }

  static inline bool private_network = false;
  const ScratchFolder folder_;
  const std::string port_ = folder_ / "tracker", err_ = folder_ / "err";
  const std::vector<std::string> words_ = {kProgram, "--port", port_, "--lcm-url", "udpm://239.255.76.67:7667?ttl=0"};
  std::optional<TerminalTracker> tracker_;
};

TEST_F(XsensProgram, ItsOrientationsComeOverLcmAndAgainWhenItWasUnplugged) {
  std::vector<bot_core::ins_t> imu;
  BusPeer peer;
  peer.keep(channel::kImu, imu);
  Program program(words_, "/dev/null", err_);
  const auto absent = [&] { return peer.summary("xsens_bridge").find("plugged in") != std::string::npos; };
  ASSERT_TRUE(run_until(peer, absent)) << said();  // At the start.
  plug_in();
  ASSERT_TRUE(run_until(peer, [&] { return imu.size() >= 20; })) << said();
  unplug();
  ASSERT_TRUE(run_until(peer, absent)) << said();
  const std::size_t before = imu.size();
  plug_in();
  ASSERT_TRUE(run_until(peer, [&] { return imu.size() >= before + 20; })) << said();
  ASSERT_TRUE(run_until(peer, [&] { return peer.summary("xsens_bridge").empty(); }));
  for (std::size_t i = 1; i < imu.size(); ++i) EXPECT_EQ(imu[i].device_time, imu[i - 1].device_time + 1);
  EXPECT_EQ(peer.counter("xsens_bridge", "xsens_openings"), 2);
  EXPECT_EQ(peer.counter("xsens_bridge", "xsens_lost_messages"), 0);
  EXPECT_EQ(program.end(SIGTERM), 0) << said();
}

TEST_F(XsensProgram, ProbeNeedsNoBusAndSaysWhatItFound) {
  const auto absent = run_command({kProgram, "--probe", "--port", port_});
  EXPECT_EQ(absent.status, 1);
  EXPECT_NE(absent.out.find("is the device plugged in"), std::string::npos) << absent.out;
  plug_in();
  std::atomic<bool> ending = false;
  std::thread tracker([&] {
    for (; !ending; std::this_thread::sleep_for(std::chrono::milliseconds(2))) tracker_->run();
  });
  const auto found = run_command({kProgram, "--probe", "--port", port_}, {"LCM_DEFAULT_URL=nowhere"});
  ending = true;
  tracker.join();
  EXPECT_EQ(found.status, 0) << found.err;
  EXPECT_NE(found.out.find("answers at 115200 baud\nproduct: MTi-30-2A8G4\ndevice id: 0368248C"), std::string::npos)
      << found.out;
}

TEST_F(XsensProgram, AnotherRateOrDeviceIsOneClearLine) {
  plug_in();
  tracker_->quiet = true;
  Random random(1);
  BusPeer peer;
  std::vector<std::string> words = words_;
  words.insert(words.end(), {"--baud", "57600"});
  Program program(words, "/dev/null", err_);
  // As at a wrong rate: bytes, and none of them makes sense. What it is asked is never heard.
  const auto told = [&] {
    tracker_->put(random_bytes(5, random));
    return said().find("; bytes come, but none of a tracker: is the rate right") != std::string::npos;
  };
  EXPECT_TRUE(peer.listen_until(told)) << said();
  EXPECT_EQ(program.end(SIGTERM), 0);
}

TEST_F(XsensProgram, WhatItCannotUseIsOneLine) {
  expect_refusals(kProgram, {
                                {{"--rate", "0"}, "--rate"},
                                {{"--robot", "/nowhere.yaml"}, "/nowhere.yaml"},
                                {{"--lcm-url", "xyz://1"}, "no provider 'xyz'"},
                            });
}

}  // namespace
}  // namespace scanway::test
