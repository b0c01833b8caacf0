#pragma once

#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "common/clock/host_time.h"
#include "common/clock/steady_time.h"
#include "modules/base_bridge/device/base_driver.h"
#include "modules/schunk_bridge/device/pan_tilt_driver.h"
#include "modules/sick_bridge/device/lms_device.h"
#include "modules/simulator/device/robot/robot_in_world.h"
#include "modules/xsens_bridge/device/tracker_device.h"
#include "tests/modules/simulator/core/test_worlds.h"
#include "tests/support/command.h"

namespace scanway::test {

using namespace simulator;

/// The robot in a room, and the bridges' devices at the ends of its cables.
class RobotInRoom : public testing::Test {
 protected:
  template <class Done>
  bool run_until(const Done& done) {
    for (const Utime limit = steady_now() + 20 * kMicrosecondsPerSecond; steady_now() < limit;) {
      simulated.wait(1);
      simulated.run(std::llround(static_cast<double>(now()) * speed));
      step_bridges();
      if (done()) return true;
    }
    return false;
  }
  void step_bridges() {
    pan_tilt.step(0);
    for (const auto& event : pan_tilt.core().take_events()) said += event.axis + ' ' + event.text + '\n';
    base.step(0);
    for (const auto& event : base.core().take_events()) said += event.text + '\n';
    auto news = lms.run(0);
    for (auto& scan : news.scans) {
      utimes.push_back(scan.utime);
      scans.push_back(std::move(scan.scan));
    }
    for (const std::string& note : news.notes) said += note + '\n';
    if (!tracker) return;
    auto heard = tracker->run(0);
    for (auto& reading : heard.readings) readings.push_back(reading.reading);
    for (const std::string& note : heard.notes) said += note + '\n';
  }
  bool has_said(const std::string& words) const { return said.find(words) != std::string::npos; }
  void add_fault(const std::string& text) { simulated.add_fault(parse_fault(text, now())); }
  Utime now() const { return steady_now() - began; }
  static Stand stand() {
    Stand stand;
    stand.X_world_base = simulator::test::tilted_pose(0.5, 1.0, 0.0, 0.7);
    return stand;
  }

  const simulator::test::Room room;
  const World world = room.world();
  const Robot robot = simulated_robot();
  ScratchFolder folder;
  const DeviceEnds ends{0, "unix:" + (folder / "can"), folder / "tracker", folder / "base"};
  RobotInWorld simulated{world, robot, stand(), 7, 4, ends};
  sick::LmsDevice lms{{"127.0.0.1", simulated.lms_port()}, {}};
  schunk::PanTiltDriver pan_tilt{ends.can, {}};
  erratic::BaseDriver base{ends.base, {}};
  std::optional<xsens::TrackerDevice> tracker;  // Where a test wants it.
  std::vector<xsens::TrackerReading> readings;
  std::string said;  // By the bridges' devices, a line each.
  std::vector<sick::Scan> scans;
  std::vector<Utime> utimes;  // By the bridge, on the host's clock.
  const Utime began = steady_now(), host_began = host_now();
  double speed = 1.0;
};

}  // namespace scanway::test
