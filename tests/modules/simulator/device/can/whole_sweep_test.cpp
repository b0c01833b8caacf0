// scanway-schunk and the emulated PW-70 on a CAN bus, a real vcan0 and a pretended one: a whole sweep at high speed.
#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include <gtest/gtest.h>

#include "bot_core/joint_state_t.hpp"
#include "common/can/can_link.h"
#include "common/files/input_error.h"
#include "modules/simulator/device/pan_tilt/pan_tilt_module.h"
#include "scanway/pan_tilt_command_t.hpp"
#include "scanway/sweep_mark_t.hpp"
#include "tests/support/bus_peer.h"
#include "tests/support/command.h"
#include "tests/support/private_network.h"
#include "tests/support/program.h"

namespace scanway::test {
namespace {

using simulator::ModuleConfig;
using simulator::PanTiltModule;

constexpr double kSpeed_deg_s = 120.0;  // Forty times that of a survey.
constexpr double kSweep_deg = 360.0;
constexpr double kAcceleration_deg_s2 = 720.0;

bool can_was_promised() { return std::getenv("REQUIRE_CAN") != nullptr; }
/// The guest kernel's network is a private one by itself.
const bool kPrivateNetwork = can_was_promised() || enter_private_network();

/// The emulated PW-70, alive on the bus in a thread of its own, with the host's clock.
class EmulatedPanTilt {
 public:
  explicit EmulatedPanTilt(const std::string& can) : link_(serve_can(can)), thread_([this] { live(); }) {}
  ~EmulatedPanTilt() {
    end_ = true;
    thread_.join();
  }
  /// The truth.
  double pan_angle(Utime utime) {
    const std::lock_guard lock(mutex_);
    return pan_.angle(utime - began_);
  }

 private:
  static ModuleConfig config_of(std::uint8_t id) {
    ModuleConfig config;
    config.id = id;
    config.referenced = true;
    config.acceleration = radians(kAcceleration_deg_s2);
    return config;
  }
  void live() {
    while (!end_) {
      const auto received = link_->receive(1);
      const std::lock_guard lock(mutex_);
      const Utime now = host_now() - began_;
      for (PanTiltModule* module : {&pan_, &tilt_}) {
        if (received && received->frame) module->receive(*received->frame, now);
        module->tick(now);
        for (const CanFrame& frame : module->take_frames()) link_->send(frame);
      }
    }
  }

  std::unique_ptr<CanLink> link_;
  const Utime began_ = host_now();
  PanTiltModule pan_{config_of(11)}, tilt_{config_of(12)};
  std::mutex mutex_;
  std::atomic<bool> end_ = false;
  std::thread thread_;
};

bool is_there(const std::string& can) {
  try {
    serve_can(can);
    return true;
  } catch (const InputError&) {
    return false;
  }
}

class WholeSweep : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    if (!kPrivateNetwork) GTEST_SKIP() << "network namespaces are not permitted here (unshare --net)";
    if (GetParam() == std::string("unix") || is_there(can)) return;
    if (can_was_promised()) FAIL() << "CAN was promised (REQUIRE_CAN), and there is no vcan0";
    GTEST_SKIP() << "no vcan0 on this machine; the guest kernel's run has one";
  }
  std::int64_t counter(const std::string& name) const { return peer.counter("schunk_bridge", "schunk_" + name); }
  bool marked(std::int8_t mark) {
    return peer.listen_until([&] { return !marks.empty() && marks.back().mark == mark; });
  }
  /// How far what the bridge has told of the pan is from where it was then, at worst and on average.
  void compare_with_truth() {
    for (; compared < states.size(); ++compared) {
      const double off = std::fabs(states[compared].joint_position[0] - pan_tilt->pan_angle(states[compared].utime));
      sum += off;
      worst = std::max(worst, off);
    }
  }

  const ScratchFolder folder;
  const std::string can = GetParam() == std::string("unix") ? "unix:" + folder / "can" : GetParam();
  std::optional<EmulatedPanTilt> pan_tilt;
  BusPeer peer;
  std::vector<bot_core::joint_state_t> states;
  std::vector<sweep_mark_t> marks;
  std::size_t compared = 0;
  double sum = 0.0, worst = 0.0;
};

TEST_P(WholeSweep, AtHighSpeedIsToldAsItWas) {
  pan_tilt.emplace(can);
  write_text(folder / "robot.yaml", "schema: 1\npan: {speed_deg_s: 120, sweep_deg: 360}\n");
  const std::string err = folder / "err";
  Program program({std::string(SCANWAY_BIN_DIR) + "/scanway-schunk", "--can", can, "--lcm-url",
                   "udpm://239.255.76.67:7667?ttl=0", "--robot", folder / "robot.yaml"},
                  "/dev/null", err);
  peer.keep(channel::kPanTiltState, states);
  peer.keep(channel::kSweepMark, marks);
  ASSERT_TRUE(peer.listen_until([&] { return !states.empty(); })) << read_text(err);
  pan_tilt_command_t sweep{};
  sweep.command = pan_tilt_command_t::SWEEP;
  sweep.utime = host_now();
  sweep.pan_rad = sweep.tilt_rad = sweep.pan_speed_rad_s = sweep.tilt_speed_rad_s =
      std::numeric_limits<double>::quiet_NaN();
  peer.say(channel::kPanTiltCommand, sweep);
  ASSERT_TRUE(marked(sweep_mark_t::STARTED)) << read_text(err);
  const sweep_mark_t started = marks.back();
  states.clear();
  ASSERT_TRUE(peer.listen_until([&] {
    compare_with_truth();
    return marks.back().mark == sweep_mark_t::ENDED;
  })) << read_text(err);
  const sweep_mark_t ended = marks.back();
  EXPECT_NEAR(ended.pan_rad - started.pan_rad, radians(kSweep_deg), radians(2));
  // It speeds up and brakes on its way.
  EXPECT_NEAR(to_seconds(ended.utime - started.utime), kSweep_deg / kSpeed_deg_s + kSpeed_deg_s / kAcceleration_deg_s2,
              0.05);
  const double rate_hz = static_cast<double>(states.size()) / to_seconds(ended.utime - started.utime);
  const double mean = sum / static_cast<double>(states.size());
  std::printf("%zu states, %.0f a second; off by %.2f ms on average, %.2f ms at worst\n", states.size(), rate_hz,
              1e3 * mean / radians(kSpeed_deg_s), 1e3 * worst / radians(kSpeed_deg_s));
  EXPECT_GT(rate_hz, 35.0);
  EXPECT_LT(mean, radians(kSpeed_deg_s) * 0.01);  // 10 ms of its turn.
  ASSERT_TRUE(peer.listen_until([&] { return counter("sweeps_ended") == 1; })) << read_text(err);
  for (const char* bad : {"bad_frames", "times_lost", "errors", "bad_messages", "sweeps_aborted"}) {
    EXPECT_EQ(counter(bad), 0) << bad;
  }
  EXPECT_LE(counter("state_gaps"), 10);  // The module's thread is not always let run in time: the guest has one CPU.
  EXPECT_EQ(program.end(), 0);
}

INSTANTIATE_TEST_SUITE_P(OnTheBus, WholeSweep, testing::Values("unix", "vcan0"),
                         [](const auto& bus) { return std::string(bus.param); });

}  // namespace
}  // namespace scanway::test
