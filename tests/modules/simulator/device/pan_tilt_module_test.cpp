#include "modules/simulator/device/pan_tilt/pan_tilt_module.h"

#include <bit>
#include <cmath>
#include <cstdlib>
#include <map>
#include <sstream>

#include "common/can/can_link.h"
#include "common/clock/steady_time.h"
#include "modules/schunk_bridge/device/pan_tilt_driver.h"
#include "tests/modules/simulator/device/shared_facts.h"

namespace scanway::test {
namespace {

using namespace simulator;

/// The sheet's vectors: name to "701#0795..." as candump writes frames.
std::map<std::string, std::string> motion_vectors() {
  std::istringstream lines(facts_text("schunk/smp_can_vectors.csv"));
  std::map<std::string, std::string> all;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream row(line);
    std::vector<std::string> fields(5);
    for (std::string& field : fields) std::getline(row, field, ',');
    all[fields[0]] = fields[4];
  }
  return all;
}

CanFrame frame_of(const std::string& candump) {
  CanFrame frame;
  frame.id = static_cast<std::uint16_t>(std::strtoul(candump.c_str(), nullptr, 16));
  const std::string bytes = unhex(candump.substr(candump.find('#') + 1));
  frame.size = static_cast<std::uint8_t>(bytes.size());
  std::copy(bytes.begin(), bytes.end(), frame.data.begin());
  return frame;
}

std::string text_of(const CanFrame& frame) {
  char id[8];
  std::snprintf(id, sizeof id, "%03X#", frame.id);
  std::string text = id;
  text += hex_of({frame.data.begin(), frame.data.begin() + frame.size});
  return text;
}

std::string text_of(const std::vector<CanFrame>& frames) {
  std::string all;
  for (const CanFrame& frame : frames) {
    if (!all.empty()) all += ' ';
    all += text_of(frame);
  }
  return all;
}

MotionMessage message_of(std::uint8_t command, const std::vector<float>& values, const MotionMessage& tail = {}) {
  MotionMessage message{command};
  for (const float value : values) append_little_endian(message, std::bit_cast<std::uint32_t>(value), 4);
  message.insert(message.end(), tail.begin(), tail.end());
  return message;
}

TEST(MotionMessage, TheSheetsFramesByteForByte) {
  SKIP_WITHOUT_FACTS();
  auto vectors = motion_vectors();
  const auto check = [&](const std::vector<std::string>& names, const MotionMessage& message, MotionClass who,
                         std::uint8_t module) {
    std::string expected;
    for (const std::string& name : names) {
      if (!expected.empty()) expected += ' ';
      expected += vectors.at(name);
    }
    EXPECT_EQ(text_of(frames_of(message, who, module)), expected);
  };
  const auto module = MotionClass::from_module;
  check({"state_pos_moving"}, message_of(0x95, {std::bit_cast<float>(0x3F818936)}, {2, 0}), module, 1);
  check(
      {"state_full_f1", "state_full_f2", "state_full_f3"},
      message_of(0x95,
                 {std::bit_cast<float>(0x4170A3D6), std::bit_cast<float>(0x4041C956), std::bit_cast<float>(0x3EEB413C)},
                 {3, 0}),
      module, 1);
  check({"state_full_estop_f1", "state_full_estop_f2", "state_full_estop_f3"},
        message_of(0x95, {std::bit_cast<float>(0x41B76353), 0, 0}, {0x61, 0xD9}), module, 1);
  check({"state_posvel_f1", "state_posvel_f2"}, message_of(0x95, {45.5F, -12.25F}, {3, 0}), module, 11);
  check({"error_tow"}, {0x88, 0xDA}, MotionClass::error, 1);
}

/// What the module says to these requests at once.
std::string answers(PanTiltModule& module, const std::vector<std::string>& requests, Utime now) {
  module.tick(now);
  module.take_frames();  // What it had to say before.
  for (const std::string& request : requests) module.receive(frame_of(request), now);
  module.tick(now);
  return text_of(module.take_frames());
}

TEST(PanTiltModule, AnswersTheSheetsRequests) {
  SKIP_WITHOUT_FACTS();
  auto vectors = motion_vectors();
  ModuleConfig config;
  config.id = 1;
  PanTiltModule module(config);
  Utime now = 0;
  module.tick(now);
  EXPECT_EQ(text_of(module.take_frames()), vectors.at("info_boot"));
  const std::pair<const char*, const char*> kDialogue[] = {{"get_state_once_pos", "state_not_referenced"},
                                                           {"set_target_vel_122", "set_target_vel_ok"},
                                                           {"set_target_acc_req", "set_target_acc_ok"},
                                                           {"set_target_jerk_req", "set_target_jerk_ok"},
                                                           {"set_target_cur_req", "set_target_cur_ok"},
                                                           {"set_target_time_req", "set_target_time_ok"},
                                                           {"set_config_id", "set_config_id_ok"},
                                                           {"toggle_impulse_req", "toggle_impulse_off"},
                                                           {"toggle_impulse_req", "toggle_impulse_on"},
                                                           {"move_vel_111", "move_vel_ok"},
                                                           {"stop_req", "stop_ok"},
                                                           {"fast_stop_req", "fast_stop_error"},
                                                           {"detailed_error_req", "detailed_error_ans"},
                                                           {"reboot_req", "reboot_ok"}};
  for (const auto& [request, answer] : kDialogue) {
    EXPECT_EQ(answers(module, {vectors.at(request)}, now), vectors.at(answer)) << request;
    now += 1000;
  }
}

TEST(PanTiltModule, ReferenceMoveStopAndErrorWithItsImpulses) {
  SKIP_WITHOUT_FACTS();
  auto vectors = motion_vectors();
  ModuleConfig config;
  config.id = 1;
  config.angle = radians(20);
  PanTiltModule module(config);
  module.tick(0);
  EXPECT_EQ(answers(module, {vectors.at("move_pos_10")}, 0), "701#02B006") << "not referenced";
  EXPECT_EQ(answers(module, {vectors.at("reference_req")}, 0), vectors.at("reference_ok"));
  module.tick(5'000'000);
  EXPECT_EQ(text_of(module.take_frames()), "701#059400000000");
  const std::string going = answers(module, {vectors.at("set_target_vel_30"), vectors.at("move_pos_10")}, 6'000'000);
  EXPECT_EQ(going.substr(0, 8), "701#05B0") << "(the target speed was for another module)";
  module.tick(6'100'000);
  EXPECT_TRUE(module.take_frames().empty());
  module.tick(9'000'000);
  EXPECT_EQ(text_of(module.take_frames()), "701#059400002041");
  EXPECT_DOUBLE_EQ(module.angle(9'000'000), radians(10));
  EXPECT_EQ(answers(module, {vectors.at("fast_stop_req")}, 9'000'000), vectors.at("fast_stop_error"));
  EXPECT_EQ(answers(module, {vectors.at("move_pos_10")}, 9'100'000), "701#02B005");
  module.tick(23'900'000);
  EXPECT_TRUE(module.take_frames().empty());
  module.tick(24'000'000);
  EXPECT_EQ(text_of(module.take_frames()), vectors.at("fast_stop_error")) << "again after 15 s";
  EXPECT_EQ(answers(module, {vectors.at("ack_req")}, 25'000'000),
            vectors.at("ack_ok") + ' ' + vectors.at("info_no_error"));
}

TEST(PanTiltModule, TakesFragmentsAndStopsAtItsLimit) {
  SKIP_WITHOUT_FACTS();
  auto vectors = motion_vectors();
  for (const std::vector<std::string>& names : {std::vector<std::string>{"egl_vel30_cur1_f1", "egl_vel30_cur1_f2"},
                                                {"egl_vel30_cur1_f1", "egl_vel30_cur1_3f_2", "egl_vel30_cur1_3f_3"}}) {
    ModuleConfig config;
    config.id = 12;
    config.referenced = true;
    config.high = radians(45);
    PanTiltModule module(config);
    module.tick(0);
    std::vector<std::string> frames;
    for (const std::string& name : names) frames.push_back(vectors.at(name));
    EXPECT_EQ(answers(module, frames, 0), "70C#03B54F4B");
    module.tick(1'000'000);
    EXPECT_NEAR(module.speed(1'000'000), radians(30), 1e-9);
    module.tick(2'000'000);
    EXPECT_EQ(text_of(module.take_frames()), "30C#0288D6");
    EXPECT_LE(module.angle(2'000'000), radians(45));
  }
}

TEST(Trajectory, HasNoJumpsAndKeepsItsLimits) {
  Trajectory trajectory(0.3);
  Utime now = 1000;
  double last_angle = 0.3, last_speed = 0.0;
  for (int move = 0; move < 200; ++move) {
    const double target = 2.0 * std::sin(7.0 * move), speed = 0.5 + 0.4 * std::sin(3.0 * move);
    if (move % 3 == 2) {
      trajectory.turn_at(speed * (move % 2 == 0 ? 1 : -1), 3.0, now);
    } else {
      trajectory.move_to(target, speed, 3.0, now);
    }
    const Utime until =
        move % 5 == 0 && trajectory.end() != Trajectory::kNever ? trajectory.end() + 3000 : now + 400'000;
    for (; now < until; now += 1000) {
      ASSERT_NEAR(trajectory.angle(now), last_angle, 1e-3) << move;
      ASSERT_NEAR(trajectory.speed(now), last_speed, 3.1e-3) << move;
      last_angle = trajectory.angle(now);
      last_speed = trajectory.speed(now);
    }
    if (move % 5 == 0 && move % 3 != 2) {
      EXPECT_EQ(trajectory.angle(now), target) << move;
    }
  }
}

/// Two modules and the bridge's device on one bus.
class OnTheBus : public testing::Test {
 protected:
  template <class Done>
  bool run_until(const Done& done, int limit_s = 20) {
    for (const Utime end = steady_now() + limit_s * kMicrosecondsPerSecond; steady_now() < end;) {
      for (int i = 0; i < 4; ++i) {
        const auto received = hub->receive(0);
        if (!received || !received->frame) continue;
        pan.receive(*received->frame, steady_now() - began);
        tilt.receive(*received->frame, steady_now() - began);
      }
      for (PanTiltModule* module : {&pan, &tilt}) {
        module->tick(steady_now() - began);
        for (const CanFrame& frame : module->take_frames()) hub->send(frame);
      }
      driver.step(1);
      for (auto& event : driver.core().take_events()) events.push_back(event.text);
      if (done()) return true;
    }
    return false;
  }
  bool ready() const {
    return driver.core().pan().phase() == schunk::Axis::Phase::ready &&
           driver.core().tilt().phase() == schunk::Axis::Phase::ready;
  }
  bool stands() const { return !driver.core().pan().motion().under_way(); }

  static ModuleConfig module(std::uint8_t id, MotionUnits units) {
    ModuleConfig config;
    config.id = id;
    config.units = units;
    config.angle = radians(15);
    return config;
  }

  ScratchFolder folder;
  std::string name = "unix:" + (folder / "can");
  std::unique_ptr<CanLink> hub = serve_can(name);
  PanTiltModule pan{module(11, MotionUnits::degree)}, tilt{module(12, MotionUnits::millidegree)};
  mutable schunk::PanTiltDriver driver{name, {}};
  std::vector<std::string> events;
  Utime began = steady_now();
};

TEST_F(OnTheBus, TheBridgeReferencesMovesAndStopsBothModules) {
  ASSERT_TRUE(run_until([&] { return ready(); }));
  EXPECT_NEAR(driver.core().pan().state()->position, radians(15), 1e-6);
  EXPECT_NEAR(driver.core().tilt().state()->position, radians(15), 1e-5);
  EXPECT_EQ(driver.core().reference(driver.now()), "");
  ASSERT_TRUE(run_until([&] { return driver.core().pan().referenced() && driver.core().tilt().referenced(); }));
  ASSERT_TRUE(run_until([&] { return stands() && !driver.core().tilt().motion().under_way(); }));

  EXPECT_EQ(driver.core().move_pan(radians(-40), radians(120), driver.now()), "");
  EXPECT_EQ(driver.core().move_tilt(radians(10), radians(60), driver.now()), "");
  ASSERT_TRUE(run_until([&] { return stands() && !driver.core().tilt().motion().under_way(); }));
  EXPECT_NEAR(pan.angle(steady_now() - began), radians(-40), 1e-6);
  EXPECT_NEAR(driver.core().pan().state()->position, radians(-40), 1e-6);
  EXPECT_NEAR(driver.core().tilt().state()->position, radians(10), 2e-5);

  EXPECT_EQ(driver.core().turn_pan(radians(90), driver.now()), "");
  ASSERT_TRUE(run_until([&] { return driver.core().pan().state()->velocity > radians(80); }));
  EXPECT_NEAR(*driver.core().pan().state()->velocity, pan.speed(steady_now() - began), radians(25));
  driver.core().stop(driver.now());
  ASSERT_TRUE(run_until([&] { return pan.speed(steady_now() - began) == 0.0; }));

  tilt.fail(0xDA, steady_now() - began);
  ASSERT_TRUE(run_until([&] { return driver.core().tilt().error() == 0xDA; }));
  EXPECT_EQ(driver.core().acknowledge(), "");
  ASSERT_TRUE(run_until([&] { return driver.core().tilt().error() == 0; }));
  EXPECT_EQ(driver.core().pan().counters().bad_frames + driver.core().tilt().counters().bad_frames, 0U);
  EXPECT_EQ(driver.core().pan().counters().times_lost + driver.core().tilt().counters().times_lost, 0U);
}

}  // namespace
}  // namespace scanway::test
