// `scanway command` itself, against a bridge that the test pretends to be.
#include <gtest/gtest.h>

#include "common/health/health.h"
#include "scanway/pan_tilt_command_t.hpp"
#include "scanway/sweep_mark_t.hpp"
#include "tests/support/bus_peer.h"
#include "tests/support/command.h"
#include "tests/support/private_network.h"
#include "tests/support/program.h"

namespace scanway::test {
namespace {

/// HEALTH of a bridge that has so much to say that it takes several messages.
std::vector<health_t> talkative_health(Utime command, std::int64_t sweep, Utime now) {
  Health health;
  health.counters = {{"schunk_last_command", command}, {"schunk_last_command_refused", 0}, {"schunk_sweep", sweep}};
  for (int i = 0; i < 60; ++i) health.counters["schunk_more_to_count_" + std::to_string(i)] = i;
  return to_messages({"schunk_bridge", "robot", 1, 1000}, health, now);
}

TEST(ScanwayCommand, UnderstandsABridgeWhoseHealthComesInSeveralMessages) {
  if (!enter_private_network()) GTEST_SKIP() << "network namespaces are not permitted here (unshare --net)";
  const ScratchFolder folder;
  BusPeer peer;
  std::vector<pan_tilt_command_t> commands;
  peer.keep(channel::kPanTiltCommand, commands);
  ASSERT_GT(talkative_health(0, 6, 1).size(), 1U);
  Program command(
      {std::string(SCANWAY_BIN_DIR) + "/scanway", "command", "sweep", "--lcm-url", "udpm://239.255.76.67:7667?ttl=0"},
      folder / "out", folder / "err");
  ASSERT_TRUE(peer.listen_until([&] { return !commands.empty(); })) << read_text(folder / "err");
  Utime now = 2000;
  SteadyTime next = 0;
  const auto ended = [&] {
    if (steady_now() < next) return !command.runs();
    for (const health_t& part : talkative_health(commands.front().utime, 7, ++now)) {
      peer.say(channel::kHealth, part);
      peer.listen_until([] { return false; }, 0.05);  // So that the parts are heard one by one.
    }
    sweep_mark_t mark{};
    mark.numbered_since = 1000;
    mark.sweep = 7;
    mark.mark = sweep_mark_t::ENDED;
    mark.utime = now;
    mark.sweep_angle_rad = mark.pan_speed_rad_s = 1.0;
    peer.say(channel::kSweepMark, mark);
    next = steady_now() + 300'000;
    return !command.runs();
  };
  EXPECT_TRUE(peer.listen_until(ended)) << read_text(folder / "out") << read_text(folder / "err");
  EXPECT_NE(read_text(folder / "out").find("sweep 7 has ended"), std::string::npos) << read_text(folder / "out");
}

}  // namespace
}  // namespace scanway::test
