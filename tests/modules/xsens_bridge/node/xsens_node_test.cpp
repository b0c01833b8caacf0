// The bridge of the tracker as it runs, but for LCM: a tracker on a pseudo-terminal, the node, a bus in memory.
#include "modules/xsens_bridge/node/xsens_node.h"

#include <chrono>
#include <cmath>
#include <filesystem>
#include <functional>

#include "common/bus/channels.h"
#include "common/bus/memory_bus.h"
#include "common/messages/codec.h"
#include "common/messages/imu_message.h"
#include "tests/modules/xsens_bridge/shared_xsens.h"
#include "tests/modules/xsens_bridge/terminal_tracker.h"
#include "tests/support/command.h"

namespace scanway::test {
namespace {

/// The bridge, and what it said so far.
class Bridge {
 public:
  Bridge(const std::string& port, const Robot::Tracker& tracker = {}, int baud = 115200)
      : device_({port, baud}, {}, xsens::accuracy_of(tracker)), node_(bus_, device_, tracker) {
    bus_.subscribe(channel::kImu.name,
                   [this](const BusMessage& message) { imu.push_back(decode<bot_core::ins_t>(message.bytes)); });
  }

  void turn() {
    for (std::string& note : node_.run(1)) notes.push_back(std::move(note));
    if (std::string note = node_.take_welcome(); !note.empty()) notes.push_back(std::move(note));
    bus_.dispatch();
  }
  /// Runs tracker (or none) and bridge until `done`; false: not within ten seconds.
  bool run_until(TerminalTracker* tracker, const std::function<bool()>& done) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(10);
    while (!done() && std::chrono::steady_clock::now() < end) {
      if (tracker != nullptr) tracker->run();
      turn();
    }
    return done();
  }
  bool run_until_imu(TerminalTracker& tracker, std::size_t more) {
    const std::size_t wanted = imu.size() + more;
    return run_until(&tracker, [&] { return imu.size() >= wanted; });
  }
  std::int64_t counter(const std::string& name) const { return node_.counters().at(name); }
  std::string summary() const { return node_.summary(); }
  bool noted(const std::string& text) const {
    return std::any_of(notes.begin(), notes.end(), [&](const auto& note) { return note.find(text) != note.npos; });
  }

  std::vector<bot_core::ins_t> imu;
  std::vector<std::string> notes;

 private:
  MemoryBus bus_;
  xsens::TrackerDevice device_;
  xsens::XsensNode node_;
};

/// A tracker under a name of its own that can be unplugged.
class Plug {
 public:
  std::string port() const { return folder_ / "tracker"; }
  TerminalTracker& plug_in() {
    tracker_.emplace(false);
    std::filesystem::create_symlink(tracker_->path(), port());
    return *tracker_;
  }
  void unplug() {
    tracker_.reset();
    std::filesystem::remove(port());
  }

 private:
  ScratchFolder folder_;
  std::optional<TerminalTracker> tracker_;
};

/// Roll, pitch and yaw in degrees, by the sheet's formula.
Eigen::Matrix3d rotation_of(const nlohmann::json& euler_deg) {
  const double roll = euler_deg[0].get<double>() * M_PI / 180, pitch = euler_deg[1].get<double>() * M_PI / 180,
               yaw = euler_deg[2].get<double>() * M_PI / 180;
  return (Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()) * Eigen::AngleAxisd(pitch, Eigen::Vector3d::UnitY()) *
          Eigen::AngleAxisd(roll, Eigen::Vector3d::UnitX()))
      .toRotationMatrix();
}

const nlohmann::json* item(const nlohmann::json& message, const std::string& name) {
  for (const auto& item : message["items"]) {
    if (item["name"] == name) return &item["value"];
  }
  return nullptr;
}

/// The captures' tracker stands on its side; mounted like that, the base is level.
class RecordedStream : public testing::TestWithParam<const char*> {};

TEST_P(RecordedStream, PassesThroughTheBridge) {
  SKIP_WITHOUT_XSENS_FACTS();
  const std::string name = std::string("captures/") + GetParam();
  const auto said = xsens_json(name + ".json")["messages"];
  const std::string stream = read_text(kXsensFacts + name + ".bin");
  Robot::Tracker tracker;
  tracker.mount_roll_pitch_yaw = {radians(-99.5L), 0.0, radians(30)};
  TerminalTracker terminal(false);
  Bridge bridge(terminal.path(), tracker);
  ASSERT_TRUE(bridge.run_until_imu(terminal, 1));
  terminal.quiet = true;
  for (int i = 0; i < 20; ++i) bridge.turn();
  bridge.imu.clear();
  for (std::size_t at = 0; at < stream.size(); at += 700) {
    const std::string piece = stream.substr(at, 700);
    terminal.put({piece.begin(), piece.end()});
    bridge.turn();
  }
  ASSERT_EQ(terminal.lost, 0);
  ASSERT_TRUE(bridge.run_until(nullptr, [&] { return bridge.imu.size() >= 95; }));
  std::size_t next = 0;
  for (const auto& message : said) {
    const auto* euler = item(message, "euler_rpy_deg");
    if (euler == nullptr) continue;  // GNSS alone.
    ASSERT_LT(next, bridge.imu.size());
    const bot_core::ins_t& imu = bridge.imu[next++];
    // The frame of the captures is x east, y north, z up: R_world_base = R_world_sensor R_sensor_base.
    const Eigen::Matrix3d R = rotation_of(*euler) * tracker.R_base_tracker().transpose();
    EXPECT_LT((orientation_of(imu).toRotationMatrix() - R).norm(), 1e-5);
    const auto& a = *item(message, "acceleration");
    const Eigen::Vector3d a_base =
        tracker.R_base_tracker() * Eigen::Vector3d(a[0].get<double>(), a[1].get<double>(), a[2].get<double>());
    EXPECT_NEAR((Eigen::Vector3d(imu.accel[0], imu.accel[1], imu.accel[2]) - a_base).norm(), 0, 1e-6);
    EXPECT_NEAR(a_base.z(), 9.8, 0.1);
    EXPECT_TRUE(std::isnan(imu.mag[0]));
  }
  EXPECT_EQ(next, bridge.imu.size());
  // Numbered by the tracker's counter: those with GNSS alone are the gaps. None is missing in the recording.
  const auto first = *item(said[1], "packet_counter"), last = *item(said[99], "packet_counter");
  EXPECT_EQ(bridge.imu.back().device_time - bridge.imu.front().device_time,
            static_cast<std::uint16_t>(last.get<int>() - first.get<int>()));
  EXPECT_EQ(bridge.counter("xsens_bad_bytes"), 0);
}

INSTANTIATE_TEST_SUITE_P(All, RecordedStream,
                         testing::Values("mtig710-euler-float32", "mtig710-euler-fp1220", "mtig710-euler-float64"));

TEST(XsensNode, CountsLostMessagesOverTheWrapOfTheCounter) {
  TerminalTracker terminal(false);
  Bridge bridge(terminal.path());
  ASSERT_TRUE(bridge.run_until_imu(terminal, 1));
  EXPECT_TRUE(bridge.noted("MTi-30-2A8G4 measures (MTData2, 115200 baud)"));
  terminal.quiet = true;
  const auto first = static_cast<std::uint16_t>(bridge.imu.back().device_time);
  ASSERT_GT(first, 65000);  // The test wants it near its wrap.
  const std::int64_t number = bridge.imu.back().device_time;
  for (const int step : {1, 2, 5, 6, 20}) terminal.put(small_mtdata2(static_cast<std::uint16_t>(first + step)));
  const std::size_t before = bridge.imu.size();
  ASSERT_TRUE(bridge.run_until(nullptr, [&] { return bridge.imu.size() >= before + 5; }));
  EXPECT_EQ(bridge.counter("xsens_lost_messages"), 2 + 13);
  EXPECT_EQ(bridge.imu.back().device_time, number + 20);
  EXPECT_EQ(bridge.summary(), "");
  EXPECT_EQ(bridge.counter("xsens_heading_sigma_mdeg"), 5000);
  EXPECT_EQ(bridge.counter("xsens_tilt_sigma_mdeg"), 500);
}

TEST(XsensNode, SaysWhenTheOrientationCannotBeTrusted) {
  TerminalTracker terminal(false);
  Bridge bridge(terminal.path());
  ASSERT_TRUE(bridge.run_until_imu(terminal, 1));
  terminal.quiet = true;
  Bytes data = xsens::open_frame(small_mtdata2(7)).data;
  data.back() = 1;  // The filter is not valid.
  terminal.put(xsens::make_frame(xsens::kMtData2, data));
  ASSERT_TRUE(bridge.run_until(nullptr, [&] { return bridge.counter("xsens_unhealthy") == 1; }));
  EXPECT_NE(bridge.summary().find("the tracker's filter is not valid"), std::string::npos);
  EXPECT_EQ(bridge.counter("xsens_heading_sigma_mdeg"), 50'000);
}

TEST(XsensNode, DamagedBytesAreNoOrientation) {
  TerminalTracker terminal(false);
  Bridge bridge(terminal.path());
  ASSERT_TRUE(bridge.run_until_imu(terminal, 1));
  terminal.quiet = true;
  while (bridge.counter("xsens_messages") > static_cast<std::int64_t>(bridge.imu.size())) bridge.turn();
  for (int i = 0; i < 20; ++i) bridge.turn();
  const std::size_t before = bridge.imu.size();
  const auto next = static_cast<std::uint16_t>(bridge.imu.back().device_time + 1);
  Bytes broken = small_mtdata2(next);
  broken[12] ^= 0x10;
  terminal.put(broken);
  terminal.put(small_mtdata2(static_cast<std::uint16_t>(next + 1)));
  ASSERT_TRUE(bridge.run_until(nullptr, [&] { return bridge.imu.size() == before + 1; }));
  EXPECT_EQ(bridge.counter("xsens_bad_bytes"), static_cast<std::int64_t>(broken.size()));
  EXPECT_EQ(bridge.counter("xsens_lost_messages"), 1);
}

TEST(XsensNode, AbsentAtTheStartThenUnpluggedAndBackAgain) {
  Plug plug;
  Bridge bridge(plug.port());
  ASSERT_TRUE(bridge.run_until(nullptr, [&] { return !bridge.notes.empty(); }));
  EXPECT_TRUE(bridge.noted(plug.port() + ": the serial port cannot be opened"));
  EXPECT_EQ(bridge.summary(), bridge.notes[0]);
  ASSERT_TRUE(bridge.run_until_imu(plug.plug_in(), 10));
  EXPECT_EQ(bridge.summary(), "");
  plug.unplug();
  ASSERT_TRUE(bridge.run_until(nullptr, [&] { return !bridge.summary().empty(); }));
  EXPECT_NE(bridge.summary().find(plug.port()), std::string::npos);
  ASSERT_TRUE(bridge.run_until_imu(plug.plug_in(), 10));
  EXPECT_EQ(bridge.counter("xsens_openings"), 2);
  // A tracker that was switched off counts anew, which is no loss.
  EXPECT_EQ(bridge.counter("xsens_lost_messages"), 0);
  for (std::size_t i = 1; i < bridge.imu.size(); ++i) {
    EXPECT_EQ(bridge.imu[i].device_time, bridge.imu[i - 1].device_time + 1);
  }
}

TEST(XsensNode, RebootedItIsSetUpAgain) {
  TerminalTracker terminal(false);
  Bridge bridge(terminal.path());
  ASSERT_TRUE(bridge.run_until_imu(terminal, 10));
  terminal.put(terminal.tracker().reboot());
  ASSERT_TRUE(bridge.run_until(&terminal, [&] { return bridge.counter("xsens_reboots") == 1; }));
  ASSERT_TRUE(bridge.run_until_imu(terminal, 10));
  EXPECT_EQ(bridge.counter("xsens_openings"), 1);
  EXPECT_EQ(bridge.counter("xsens_lost_messages"), 0);
}

TEST(XsensNode, SlowToStartItIsAskedAgain) {
  TerminalTracker terminal(false);
  Bridge bridge(terminal.path());
  const auto silent_until = std::chrono::steady_clock::now() + std::chrono::milliseconds(1200);
  ASSERT_TRUE(bridge.run_until(nullptr, [&] { return std::chrono::steady_clock::now() > silent_until; }));
  ASSERT_TRUE(bridge.run_until_imu(terminal, 10));
  EXPECT_EQ(bridge.counter("xsens_openings"), 1);
}

TEST(XsensNode, OlderTrackersPass) {
  SKIP_WITHOUT_XSENS_FACTS();
  TerminalTracker terminal(true);
  Bridge bridge(terminal.path());
  // Its zeros are no rotation, which is why they do not count as orientations.
  ASSERT_TRUE(bridge.run_until(&terminal, [&] { return bridge.counter("xsens_messages") > 5; }));
  terminal.quiet = true;
  terminal.put(bytes_of_spaced_hex(xsens_vector("legacy_mtig_MTData_calib_quat_counter")["hex"]));
  ASSERT_TRUE(bridge.run_until(nullptr, [&] { return bridge.imu.size() == 1; }));
  const bot_core::ins_t& imu = bridge.imu[0];
  const double expected[4] = {0.272808, -0.003220, 0.007441, -0.962034};  // As the sheet prints them, north-west-up.
  const Eigen::Quaterniond q_nwu(expected[0], expected[1], expected[2], expected[3]);
  const Eigen::Quaterniond q_enu = Eigen::Quaterniond(std::sqrt(0.5), 0, 0, std::sqrt(0.5)) * q_nwu.normalized();
  EXPECT_LT(orientation_of(imu).angularDistance(q_enu), 1e-5);
  EXPECT_NEAR(imu.accel[2], 9.817365, 1e-6);
  EXPECT_NEAR(imu.gyro[0], 0.002370, 1e-6);
  EXPECT_NEAR(imu.mag[2], -0.320288, 1e-6);
}

}  // namespace
}  // namespace scanway::test
