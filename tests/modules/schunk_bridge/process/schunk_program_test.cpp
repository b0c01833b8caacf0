// scanway-schunk itself, between LCM's bus and two test modules on a CAN bus: a real vcan0, and a pretended one.

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <sstream>

#include "bot_core/joint_state_t.hpp"
#include "common/math/angle.h"
#include "scanway/pan_tilt_command_t.hpp"
#include "scanway/sweep_mark_t.hpp"
#include "tests/modules/schunk_bridge/responder.h"
#include "tests/support/bus_peer.h"
#include "tests/support/command.h"
#include "tests/support/private_network.h"
#include "tests/support/program.h"

namespace scanway::test {
namespace {

using Command = pan_tilt_command_t;

const std::string kProgram = std::string(SCANWAY_BIN_DIR) + "/scanway-schunk";
const char* const kUrl = "udpm://239.255.76.67:7667?ttl=0";

bool can_was_promised() { return std::getenv("REQUIRE_CAN") != nullptr; }
/// The guest kernel's network is a private one by itself.
const bool kPrivateNetwork = can_was_promised() || enter_private_network();

Command command_of(std::int8_t command) {
  Command message{};
  message.command = command;
  message.pan_rad = message.tilt_rad = std::numeric_limits<double>::quiet_NaN();
  message.pan_speed_rad_s = message.tilt_speed_rad_s = std::numeric_limits<double>::quiet_NaN();
  return message;
}

Command move_to(double pan_deg, double speed_deg_s) {
  Command command = command_of(Command::MOVE);
  command.pan_rad = radians(pan_deg);
  command.pan_speed_rad_s = radians(speed_deg_s);
  return command;
}

class SchunkProgram : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    if (!kPrivateNetwork) GTEST_SKIP() << "network namespaces are not permitted here (unshare --net)";
    if (!real() || is_there(can)) return;
    if (can_was_promised()) FAIL() << "CAN was promised (REQUIRE_CAN), and there is no vcan0";
    GTEST_SKIP() << "no vcan0 on this machine; the guest kernel's run has one";
  }
  bool real() const { return GetParam() == std::string("vcan0"); }

  void start() {
    write_text(folder / "robot.yaml", "schema: 1\npan: {speed_deg_s: 45, sweep_deg: 90}\n");
    program.emplace(
        std::vector<std::string>{kProgram, "--can", can, "--lcm-url", kUrl, "--robot", folder / "robot.yaml"},
        "/dev/null", err);
    peer.keep(channel::kPanTiltState, states);
    peer.keep(channel::kSweepMark, marks);
  }
  bool get_ready() {
    return peer.listen_until([&] { return !states.empty(); });
  }
  Utime say(Command command) {
    command.utime = host_now();
    peer.say(channel::kPanTiltCommand, command);
    return command.utime;
  }
  bool moves(bool wanted) {
    return peer.listen_until(
        [&] { return responder->with([](TestModule& pan, TestModule&) { return pan.moving(); }) == wanted; });
  }
  bool marked(std::int8_t mark) {
    return peer.listen_until([&] { return !marks.empty() && marks.back().mark == mark; });
  }
  bool on_health(const std::string& words) {
    return peer.listen_until([&] { return peer.summary("schunk_bridge").find(words) != std::string::npos; });
  }
  std::int64_t counter(const std::string& name) const { return peer.counter("schunk_bridge", "schunk_" + name); }
  int times_said(const std::string& words) const {
    int times = 0;
    const std::string log = read_text(err);
    for (std::size_t at = log.find(words); at != log.npos; at = log.find(words, at + 1)) ++times;
    return times;
  }
  void set_bus(bool up) {
    if (real()) {
      ASSERT_EQ(run_command({"ip", "link", "set", can, up ? "up" : "down"}).status, 0);
    } else if (up) {
      responder.emplace(can);
    } else {
      responder.reset();
    }
  }

  const ScratchFolder folder;
  const std::string can = real() ? GetParam() : "unix:" + folder / "can";
  const std::string err = folder / "err";
  std::optional<Responder> responder{can};
  std::optional<Program> program;
  BusPeer peer;
  std::vector<bot_core::joint_state_t> states;
  std::vector<sweep_mark_t> marks;
};

/// What the bus makes a difference to.
class OnTheBus : public SchunkProgram {};
class OnAnyBus : public SchunkProgram {};

/// When candump saw the frame.
std::vector<Utime> times_in(const std::string& log, const std::string& frame) {
  std::vector<Utime> times;
  std::istringstream lines(log);
  for (std::string time, bus, seen; lines >> time >> bus >> seen;) {
    if (seen == frame)
      times.push_back(std::stoll(time.substr(1)) * 1'000'000 + std::stoll(time.substr(time.find('.') + 1)));
  }
  return times;
}

TEST_P(OnTheBus, AStopFromTheBusIsOnTheWireWithin20Milliseconds) {
  constexpr int kTimes = 9;
  std::optional<Program> candump;
  if (real()) candump.emplace(std::vector<std::string>{"candump", "-L", can}, folder / "log");
  start();
  ASSERT_TRUE(get_ready()) << read_text(err);
  std::vector<Utime> asked;
  for (int i = 0; i < kTimes; ++i) {
    say(move_to(i % 2 ? -100 : 100, 20));
    ASSERT_TRUE(moves(true)) << read_text(err);
    usleep(static_cast<useconds_t>(20'000 + 1'700 * i));  // At any moment of the bridge's turn.
    asked.push_back(say(command_of(Command::STOP)));
    ASSERT_TRUE(moves(false)) << read_text(err);
    const Utime stood = host_now() + 50'000;
    ASSERT_TRUE(peer.listen_until([&] { return states.back().utime > stood; }));
  }
  if (candump) candump->end();
  const auto seen = real() ? times_in(read_text(folder / "log"), "50B#0191") : responder->times_of(0x50B, {0x01, 0x91});
  std::vector<Utime> delays;
  for (const Utime time : asked) {
    const auto first = std::lower_bound(seen.begin(), seen.end(), time);
    ASSERT_NE(first, seen.end());
    delays.push_back(*first - time);
  }
  // The median: this machine, or the guest kernel, may sleep on any one of them.
  std::sort(delays.begin(), delays.end());
  std::printf("stop on the wire: median %.2f ms, longest %.2f ms\n", static_cast<double>(delays[kTimes / 2]) / 1000,
              static_cast<double>(delays.back()) / 1000);
  EXPECT_LE(delays[kTimes / 2], 20'000);
}

std::vector<std::string> command_words(std::vector<std::string> words, const std::string& url = kUrl) {
  words.insert(words.begin(), {std::string(SCANWAY_BIN_DIR) + "/scanway", "command", "--lcm-url", url});
  return words;
}

CommandResult command(const std::vector<std::string>& words) { return run_command(command_words(words)); }

TEST_P(OnAnyBus, AnOperatorSweepsFromATerminal) {
  Program nobody(command_words({"stop"}, "udpm://239.255.76.67:7668?ttl=0"), "/dev/null", folder / "nobody");
  responder->with([](TestModule& pan, TestModule& tilt) {
    pan.tilt_by(-50);
    tilt.tilt_by(-10);
  });
  start();
  ASSERT_TRUE(get_ready()) << read_text(err);
  const auto swept = command({"sweep"});
  EXPECT_EQ(swept.status, 0) << swept.err;
  EXPECT_EQ(swept.out, "sweep 1 has begun; it takes 2 s\nsweep 1 has ended\n");
  ASSERT_TRUE(marked(sweep_mark_t::ENDED)) << read_text(err);
  EXPECT_EQ(marks[0].mark, sweep_mark_t::STARTED);
  EXPECT_NEAR(marks[0].pan_rad, radians(-45), radians(0.3));
  EXPECT_NEAR(marks.back().pan_rad, radians(45), radians(0.3));
  EXPECT_DOUBLE_EQ(marks.back().pan_speed_rad_s, radians(45));  // As the robot file says.
  // On its way back from a whole sweep it may be stopped.
  EXPECT_EQ(command({"stop"}).out, "taken\n");
  EXPECT_TRUE(moves(false));
  EXPECT_EQ(times_said("sweep 1 is done"), 1) << read_text(err);
  const auto refused = command({"move", "--pan-deg", "1000"});
  EXPECT_EQ(refused.status, 1);
  EXPECT_NE(refused.out.find("MOVE refused: pan cannot go to 1000.00 deg"), std::string::npos) << refused.out;
  EXPECT_EQ(times_said("MOVE refused"), 1);
  // The newest mark is said again for those who missed it.
  const Utime ended = marks.back().utime;
  marks.clear();
  ASSERT_TRUE(marked(sweep_mark_t::ENDED));
  EXPECT_EQ(marks[0].utime, ended);
  EXPECT_EQ(marks[0].sweep, 1);
  // 50 states a second, fewer only where the modules themselves are held up; in order.
  EXPECT_GT(static_cast<double>(states.size()) / to_seconds(states.back().utime - states.front().utime), 25);
  for (std::size_t i = 1; i < states.size(); ++i) ASSERT_GT(states[i].utime, states[i - 1].utime);
  // Asked to end in the next sweep, it leaves nothing moving and says so.
  say(command_of(Command::SWEEP));
  ASSERT_TRUE(moves(true)) << read_text(err);
  EXPECT_EQ(program->end(SIGTERM), 0);
  EXPECT_TRUE(moves(false));
  ASSERT_TRUE(marked(sweep_mark_t::ABORTED)) << read_text(err);
  EXPECT_EQ(marks.back().sweep, 2);
  EXPECT_EQ(command({"dance"}).status, 2);
  EXPECT_EQ(nobody.end(0), 2);
  EXPECT_NE(read_text(folder / "nobody").find("no scanway-schunk is heard"), std::string::npos);
}

TEST_P(OnAnyBus, GoesOnWhenOneModuleDoesNotAnswer) {
  start();
  ASSERT_TRUE(get_ready()) << read_text(err);
  responder->with([](TestModule&, TestModule& tilt) { tilt.powered = false; });
  ASSERT_TRUE(on_health("tilt does not answer")) << peer.summary("schunk_bridge");
  states.clear();
  ASSERT_TRUE(get_ready());  // The pan goes on.
  responder->with([](TestModule&, TestModule& tilt) {
    tilt.powered = true;
    tilt.reboot(host_now());
  });
  ASSERT_TRUE(peer.listen_until([&] { return times_said("tilt (module 12) is ready") == 2; })) << read_text(err);
}

TEST_P(OnTheBus, ABusThatIsNotThereComesBackByItself) {
  set_bus(false);
  start();
  const std::string absent = real() ? "the CAN interface is down: sudo ip link set vcan0 up" : "no bus is served there";
  ASSERT_TRUE(on_health(absent)) << read_text(err);
  set_bus(true);
  ASSERT_TRUE(get_ready()) << read_text(err);
  set_bus(false);
  ASSERT_TRUE(on_health(can + ": ")) << read_text(err);
  set_bus(true);
  states.clear();
  ASSERT_TRUE(get_ready()) << read_text(err);
  EXPECT_EQ(times_said("there again"), 2) << read_text(err);
  EXPECT_LE(times_said(can + ": "), 6) << read_text(err);  // A line each.
  if (!real()) return;
  ASSERT_EQ(run_command({"cansend", can, "20000040#0000000000000000"}).status, 0);
  EXPECT_TRUE(on_health("the CAN bus reports bus off")) << peer.summary("schunk_bridge");
  EXPECT_EQ(counter("error_frames"), 1);
}

TEST_P(OnAnyBus, ProbeNeedsNoLcm) {
  ASSERT_TRUE(peer.listen_until([&] { return is_there(can); }));
  const auto found = run_command({kProgram, "--probe", "--can", can, "--lcm-url", "nonsense"});
  EXPECT_EQ(found.status, 0) << found.err;
  EXPECT_NE(found.out.find("PW-70"), std::string::npos);
  EXPECT_EQ(found.out.find("a program that pretends one") == std::string::npos, real()) << found.out;
  const auto missing = run_command({kProgram, "--probe", "--can", real() ? "can9" : can + "9"});
  EXPECT_EQ(missing.status, 2);
  EXPECT_NE(missing.err.find(real() ? "no such CAN interface" : "no bus is served there"), std::string::npos);
  EXPECT_EQ(std::count(missing.err.begin(), missing.err.end(), '\n'), 1);
}

std::string name_of(const testing::TestParamInfo<const char*>& bus) { return bus.param; }

INSTANTIATE_TEST_SUITE_P(SchunkProgram, OnTheBus, testing::Values("unix", "vcan0"), name_of);
INSTANTIATE_TEST_SUITE_P(SchunkProgram, OnAnyBus, testing::Values("unix"), name_of);

}  // namespace
}  // namespace scanway::test
