// The bridge's device against two test modules over a real vcan0.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "common/files/input_error.h"
#include "modules/schunk_bridge/device/pan_tilt_driver.h"
#include "tests/modules/schunk_bridge/responder.h"
#include "tests/support/command.h"
#include "tests/support/program.h"

namespace scanway {
namespace {

using schunk::Axis;
using schunk::Event;
using schunk::PanTiltDriver;
using test::Program;
using test::Responder;
using test::TestModule;

class Can : public testing::Test {
 protected:
  void SetUp() override {
    if (test::is_there("vcan0")) return;
    if (std::getenv("REQUIRE_CAN") != nullptr) FAIL() << "CAN was promised (REQUIRE_CAN), and there is no vcan0";
    GTEST_SKIP() << "no vcan0 on this machine";
  }

  /// Steps until `done`, and keeps what happens.
  template <class Done>
  bool run_until(const Done& done, double limit_s = 30) {
    for (const Utime end = PanTiltDriver::now() + static_cast<Utime>(limit_s * 1e6); PanTiltDriver::now() < end;) {
      driver.step(5);
      for (auto& event : driver.core().take_events()) events.push_back(std::move(event));
      for (auto& line : driver.take_troubles()) troubles.push_back(std::move(line));
      if (done()) return true;
    }
    return false;
  }
  bool get_ready() {
    return run_until([&] {
      return driver.core().pan().phase() == Axis::Phase::ready && driver.core().tilt().phase() == Axis::Phase::ready;
    });
  }
  const Event* find(Event::Kind kind) const {
    const auto found =
        std::find_if(events.begin(), events.end(), [&](const Event& event) { return event.kind == kind; });
    return found == events.end() ? nullptr : &*found;
  }
  bool in_trouble(const std::string& words) const {
    return std::any_of(troubles.begin(), troubles.end(),
                       [&](const std::string& line) { return line.find(words) != std::string::npos; });
  }

  static schunk::PanTiltConfig fast() {
    schunk::PanTiltConfig config;
    config.sweep.start = radians(-90);
    config.sweep.angle = radians(180);
    config.sweep.speed = config.sweep.travel_speed = radians(119);
    return config;
  }

  PanTiltDriver driver{"vcan0", fast()};
  std::vector<Event> events;
  std::vector<std::string> troubles;
};

TEST_F(Can, AWholeSweepThatCandumpSees) {
  const test::ScratchFolder scratch;
  Program candump({"candump", "-L", "vcan0"}, scratch / "log");
  Responder responder("vcan0");
  ASSERT_TRUE(get_ready());
  ASSERT_EQ(driver.core().start_sweep(PanTiltDriver::now()), "");
  ASSERT_TRUE(run_until([&] { return find(Event::Kind::sweep_done) != nullptr; }, 60));
  candump.end();
  const Event* start = find(Event::Kind::sweep_started);
  const Event* end = find(Event::Kind::sweep_ended);
  ASSERT_TRUE(start && end);
  EXPECT_NEAR(start->position, radians(-90), radians(0.3));
  EXPECT_NEAR(end->position, radians(90), radians(0.3));
  EXPECT_NEAR(driver.core().pan().state()->position, radians(-90), radians(0.3));
  EXPECT_EQ(driver.core().pan().counters().bad_frames, 0u);
  const std::string log = test::read_text(scratch / "log");
  EXPECT_NE(log.find("50B#05B00000B442"), std::string::npos);  // MOVE POS 90.
  EXPECT_NE(log.find("70B#0B8495"), std::string::npos);        // A fragmented state.
}

TEST_F(Can, CansendSteersIt) {
  Responder responder("vcan0");
  ASSERT_TRUE(get_ready());
  ASSERT_EQ(driver.core().move_pan(radians(350), radians(20), PanTiltDriver::now()), "");
  ASSERT_TRUE(run_until([&] { return find(Event::Kind::started) != nullptr; }));
  ASSERT_EQ(test::run_command({"cansend", "vcan0", "50B#0191"}).status, 0);
  EXPECT_TRUE(run_until([&] { return find(Event::Kind::blocked) != nullptr; }));
  ASSERT_EQ(test::run_command({"cansend", "vcan0", "30C#0288DA"}).status, 0);
  ASSERT_TRUE(run_until([&] { return find(Event::Kind::error) != nullptr; }));
  EXPECT_NE(find(Event::Kind::error)->text.find("DA TOW"), std::string::npos);
}

TEST_F(Can, ComesBackWhenTheInterfaceDoes) {
  Responder responder("vcan0");
  ASSERT_TRUE(get_ready());
  ASSERT_EQ(test::run_command({"ip", "link", "set", "vcan0", "down"}).status, 0);
  const bool said = run_until([&] { return in_trouble("the CAN interface is down: sudo ip link set vcan0 up"); }, 5);
  const bool lost = run_until([&] { return find(Event::Kind::lost) != nullptr; }, 5);
  ASSERT_EQ(test::run_command({"ip", "link", "set", "vcan0", "up"}).status, 0);
  EXPECT_TRUE(said);
  EXPECT_TRUE(lost);
  EXPECT_TRUE(get_ready());
  EXPECT_TRUE(in_trouble("there again"));
  EXPECT_EQ(troubles.size(), 2u);  // One line each.
}

TEST_F(Can, ModulesMayRestartOrStartLate) {
  EXPECT_TRUE(run_until([&] { return find(Event::Kind::lost) != nullptr; }, 5));
  Responder responder("vcan0");
  ASSERT_TRUE(get_ready());
  responder.with([](TestModule& pan, TestModule&) { pan.reboot(PanTiltDriver::now()); });
  events.clear();
  ASSERT_TRUE(run_until([&] { return find(Event::Kind::found) != nullptr; }, 10));
  EXPECT_EQ(driver.core().tilt().phase(), Axis::Phase::ready);
}

TEST_F(Can, SaysWhatTheBusReports) {
  Responder responder("vcan0");
  ASSERT_TRUE(get_ready());
  ASSERT_EQ(test::run_command({"cansend", "vcan0", "20000040#0000000000000000"}).status, 0);
  EXPECT_TRUE(run_until([&] { return in_trouble("bus off"); }, 5));
}

TEST_F(Can, NamesWhatIsWrongWithAnInterface) {
  const auto words = [](const std::string& interface) {
    try {
      open_can(interface);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(words("vcan0"), "");
  EXPECT_NE(words("can9").find("no such CAN interface"), std::string::npos);
  EXPECT_NE(words("lo").find("no CAN interface"), std::string::npos);
  EXPECT_NE(words("").find("no name"), std::string::npos);
  EXPECT_NE(words("a-name-that-is-too-long").find("no name"), std::string::npos);
}

TEST_F(Can, ProbeSaysWhatIsThere) {
  {
    Responder responder("vcan0");
    const auto found = schunk::probe("vcan0", {});
    EXPECT_TRUE(found.works);
    ASSERT_EQ(found.lines.size(), 2u);
    EXPECT_NE(found.lines[0].find("PW-70"), std::string::npos);
    schunk::PanTiltConfig config;
    config.tilt.module = 13;
    const auto others = schunk::probe("vcan0", config, 500'000);
    EXPECT_FALSE(others.works);
    EXPECT_NE(others.lines.back().find("ids answer: 11, 12"), std::string::npos);
  }
  EXPECT_NE(schunk::probe("vcan0", {}, 500'000).lines.back().find("no module answers"), std::string::npos);
}

}  // namespace
}  // namespace scanway
