#pragma once

#include <fcntl.h>
#include <poll.h>
#include <stdlib.h>
#include <termios.h>
#include <unistd.h>

#include <atomic>
#include <filesystem>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "common/clock/host_time.h"
#include "tests/modules/base_bridge/test_robot.h"

namespace scanway::test {

/// A robot at the far end of a pseudo-terminal, under a name of its own that can be unplugged.
class PluggedRobot {
 public:
  explicit PluggedRobot(std::string name) : name_(std::move(name)) {
    master_ = posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK);
    grantpt(master_);
    unlockpt(master_);
    std::filesystem::create_symlink(ptsname(master_), name_);
    // Hold the near end open, so that the far end does not hang up while the bridge opens and closes it.
    slave_ = open(ptsname(master_), O_RDWR | O_NOCTTY);
    thread_ = std::thread([this] { live(); });
  }
  ~PluggedRobot() {
    end_ = true;
    thread_.join();
    close(slave_);
    close(master_);
    std::filesystem::remove(name_);
  }
  PluggedRobot(const PluggedRobot&) = delete;
  PluggedRobot& operator=(const PluggedRobot&) = delete;

  template <class Touch>
  auto with(const Touch& touch) {
    const std::lock_guard lock(mutex_);
    return touch(robot_);
  }
  /// Since when it has been told to stand, and its motors have had no power.
  Utime still_since() const { return still_since_; }
  Utime powerless_since() const { return powerless_since_; }

 private:
  int line_baud() const {
    termios settings{};
    tcgetattr(slave_, &settings);
    return cfgetospeed(&settings) == B38400 ? 38400 : 115200;
  }
  void live() {
    while (!end_) {
      pollfd waiting{master_, POLLIN, 0};
      poll(&waiting, 1, 1);
      std::uint8_t buffer[256];
      const ssize_t count = read(master_, buffer, sizeof buffer);
      const std::lock_guard lock(mutex_);
      const bool moved = robot_.speed_mm_s != 0 || robot_.turn_deg_s != 0, powered = robot_.motors_on;
      if (count > 0) send(robot_.receive({buffer, buffer + count}, line_baud()));
      if (moved && robot_.speed_mm_s == 0 && robot_.turn_deg_s == 0) still_since_ = host_now();
      if (powered && !robot_.motors_on) powerless_since_ = host_now();
      send(robot_.run(host_now()));
    }
  }
  void send(const std::vector<std::uint8_t>& bytes) {
    if (!bytes.empty() && write(master_, bytes.data(), bytes.size()) < 0) return;
  }

  std::string name_;
  int master_ = -1, slave_ = -1;
  std::mutex mutex_;
  TestRobot robot_;
  std::atomic<Utime> still_since_ = 0, powerless_since_ = 0;
  std::atomic<bool> end_{false};
  std::thread thread_;
};

}  // namespace scanway::test
