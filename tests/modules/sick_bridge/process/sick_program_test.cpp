// scanway-sick itself, between LCM's bus on a private network and the recorded LMS511 on a TCP socket.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <memory>
#include <thread>

#include "scanway/line_request_t.hpp"
#include "tests/modules/sick_bridge/loopback_server.h"
#include "tests/modules/sick_bridge/scripted_lms.h"
#include "tests/modules/sick_bridge/whole_line.h"
#include "tests/support/bus_peer.h"
#include "tests/support/private_network.h"
#include "tests/support/program.h"
#include "tests/support/refusals.h"

namespace scanway::test {
namespace {

const std::string kProgram = std::string(SCANWAY_BIN_DIR) + "/scanway-sick";
const std::string kStream = "lms511_colab_25hz_0.1667_stream10.bin";

std::string stream() {
  const auto bytes = lms_bytes(kStream);
  return {bytes.begin(), bytes.end()};
}

class SickProgram : public testing::Test {
 protected:
  static void SetUpTestSuite() { private_network = enter_private_network(); }
  void SetUp() override {
    SKIP_WITHOUT_LMS_DATA();
    if (!private_network) GTEST_SKIP() << "network namespaces are not permitted here (unshare --net)";
    script_ = std::make_unique<ScriptedLms>(stream());
    server_ = std::make_unique<LoopbackServer>([this](const std::string& bytes) { return script_->answer(bytes); });
    program_ = {kProgram,    "--lcm-url", "udpm://239.255.76.67:7667?ttl=0", "--host",
                "127.0.0.1", "--port",    std::to_string(server_->port())};
  }
  /// Runs the device and listens to the bus until `done`.
  template <class Done>
  bool run_until(BusPeer& peer, const Done& done) {
    return peer.listen_until([&] {
      server_->run();
      return done();
    });
  }
  std::vector<std::string> with(const std::vector<std::string>& options) const {
    std::vector<std::string> words = program_;
    words.insert(words.end(), options.begin(), options.end());
    return words;
  }
  std::string said() const { return read_text(err_); }

  static inline bool private_network = false;
  const ScratchFolder folder_;
  const std::string err_ = folder_ / "err";
  std::unique_ptr<ScriptedLms> script_;
  std::unique_ptr<LoopbackServer> server_;
  std::vector<std::string> program_;
};

TEST_F(SickProgram, TheRecordedLms511OverLcm) {
  std::vector<laser_line_t> pieces;
  BusPeer peer;
  peer.keep(channel::kLaserLine, pieces);
  Program program(program_, "/dev/null", err_);
  ASSERT_TRUE(run_until(peer, [&] { return pieces.size() >= 40; })) << said();
  WholeLines lines;
  for (const laser_line_t& piece : pieces) lines.add(piece);
  const auto telegrams = telegrams_in(lms_bytes(kStream));
  for (std::size_t i = 0; i < 10; ++i) {
    const sick::Scan scan = parse_scan(telegrams[i]);
    const WholeEcho& line = lines.at(static_cast<std::int64_t>(i));
    ASSERT_TRUE(line.whole());
    EXPECT_EQ(line.head.device_time_us, scan.start_time_us);
    EXPECT_TRUE(std::equal(line.ranges.begin(), line.ranges.end(), scan.channel("DIST1")->counts.begin()));
  }
  // What is lost on the way is asked for.
  line_request_t request{};
  request.numbered_since = pieces[0].numbered_since;
  request.nranges = 1;
  request.first_line = {4};
  request.end_line = {5};
  peer.say(channel::kLineRequest, request);
  ASSERT_TRUE(run_until(peer, [&] { return pieces.size() >= 44; }));
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(encode(pieces[40 + i]), encode(pieces[16 + i]));
  ASSERT_TRUE(run_until(peer, [&] { return peer.counter("sick_bridge", "sick_lines_resent") == 1; }));
  EXPECT_EQ(peer.counter("sick_bridge", "sick_lines"), 10);
  EXPECT_EQ(peer.counter("sick_bridge", "sick_missed_scans"), 0);
  EXPECT_EQ(program.end(SIGTERM), 0) << said();
}

TEST_F(SickProgram, ALineIsOnTheBusAtOnce) {
  std::vector<laser_line_t> pieces;
  BusPeer peer;
  peer.keep(channel::kLaserLine, pieces);
  Program program(program_, "/dev/null", err_);
  ASSERT_TRUE(run_until(peer, [&] { return pieces.size() >= 40; })) << said();
  const auto scan = lms_bytes("lms511_colab_25hz_0.1667_scan_a.bin");
  std::vector<SteadyTime> delays;
  for (int i = 0; i < 15; ++i) {
    const std::size_t before = pieces.size();
    const SteadyTime sent = steady_now();
    server_->send({scan.begin(), scan.end()});
    ASSERT_TRUE(run_until(peer, [&] { return pieces.size() >= before + 4; }));
    delays.push_back(steady_now() - sent);
  }
  // The median: this machine may sleep on any one of them.
  std::nth_element(delays.begin(), delays.begin() + 7, delays.end());
  std::printf("a line is whole on the bus: median %.1f ms after the device sent it\n",
              static_cast<double>(delays[7]) / 1000);
  EXPECT_LE(delays[7], 50'000);
}

TEST_F(SickProgram, ComesBackWhenTheScannerDoes) {
  std::vector<laser_line_t> pieces;
  BusPeer peer;
  peer.keep(channel::kLaserLine, pieces);
  Program program(program_, "/dev/null", err_);
  const auto refused = [&] { return peer.summary("sick_bridge").find("Connection refused") != std::string::npos; };
  ASSERT_TRUE(run_until(peer, [&] { return pieces.size() >= 40; })) << said();
  server_->unplug();
  ASSERT_TRUE(run_until(peer, refused)) << said();
  server_->plug_in();
  ASSERT_TRUE(run_until(peer, [&] { return pieces.size() >= 80; })) << said();
  EXPECT_EQ(pieces.back().line, 19);
  EXPECT_EQ(pieces.back().numbered_since, pieces.front().numbered_since);
  ASSERT_TRUE(run_until(peer, [&] { return peer.counter("sick_bridge", "sick_connections") == 2 && !refused(); }));
  EXPECT_EQ(program.end(SIGTERM), 0) << said();
}

TEST_F(SickProgram, ProbeNeedsNoBusAndSaysWhatItFound) {
  std::atomic<bool> ending = false;
  std::thread device([&] {
    while (!ending) {
      server_->run();
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  });
  const auto found = run_command(with({"--probe"}), {"LCM_DEFAULT_URL=nowhere"});
  ending = true;
  device.join();
  EXPECT_EQ(found.status, 0) << found.err;
  EXPECT_NE(found.out.find("speaks cola_b\nfirmware: V1.80\nname: SN 18110550"), std::string::npos) << found.out;
  EXPECT_NE(found.out.find("1141 beams from -5.0000 deg in steps of 0.1667 deg"), std::string::npos) << found.out;
  server_->unplug();
  const auto absent = run_command(with({"--probe"}));
  EXPECT_EQ(absent.status, 1);
  EXPECT_NE(absent.out.find("Connection refused"), std::string::npos) << absent.out;
}

TEST_F(SickProgram, WhatItCannotUseIsOneLine) {
  expect_refusals(kProgram, {
                                {{"--frequency", "33"}, "no LMS5xx scans at 33 Hz"},
                                {{"--sector", "10", "5"}, "--sector 10,5"},
                                {{"--echo", "third"}, "--echo third"},
                                {{"--port", "fast"}, "--port"},
                                {{"--robot", "/nowhere.yaml"}, "/nowhere.yaml"},
                                {{"--lcm-url", "xyz://1"}, "no provider 'xyz'"},
                            });
}

}  // namespace
}  // namespace scanway::test
