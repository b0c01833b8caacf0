#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "common/time/utime.h"
#include "modules/simulator/device/lms/mirror.h"
#include "modules/simulator/device/lms/scan_content.h"
#include "modules/simulator/device/lms/scan_telegram.h"
#include "modules/simulator/device/lms/telegram.h"

namespace scanway::simulator {

/// An LMS511 as the host hears it: bytes in, bytes out, its own clock as an argument (microseconds since it was
/// switched on). One connection at a time. It answers in the dialect of the request.
class LmsEmulator {
 public:
  using Look = std::function<ScannedLine(const MirrorTurn&)>;

  /// `look` is asked once for each scan that is sent, after its last beam.
  explicit LmsEmulator(Look look) : look_(std::move(look)) {}

  /// Its answers.
  std::string receive(std::string_view bytes, Utime now);
  /// The next scans that are due by now, some at a time, each a frame.
  std::vector<std::string> tick(Utime now);
  /// Subscriptions and login end with the connection; settings stay.
  void hang_up();

  /// Switched off and on: its clock and its counters begin anew, its settings stay.
  void reboot();
  enum class Window : std::uint8_t { clean = 0, dirt_warning = 1, dirt_error = 2 };
  /// What it says of its window, in every scan and on request.
  void set_window(Window window) { window_ = window; }

  /// Lives `speed` seconds in one second of the host, and from now on tells its times and rates by the host's: a
  /// scanner whose mirror turns that much faster.
  void tell_host_time(double speed) { speed_ = speed; }

  bool measuring() const { return measuring_; }
  const Mirror& mirror() const { return mirror_; }
  /// Scans that were due and never sent, since too many of them waited for a host, or an emulator, that is too slow.
  std::int64_t dropped() const { return dropped_; }
  /// Contents of a variable that it only keeps (CoLa-B).
  void keep(const std::string& name, const std::string& value) { kept_[name] = value; }

 private:
  std::string answer(const HostRequest& request, Utime now);
  std::string read(const HostRequest& request, Utime now);
  std::string write(const HostRequest& request);
  std::string call(const HostRequest& request, Utime now);
  std::string subscribe(const HostRequest& request, Utime now);
  std::string set_mode(const HostRequest& request, Utime now);
  ScanTelegram scan(std::int64_t number, Utime now);

  Look look_;
  HostRequests requests_;
  Cola cola_ = Cola::b;  // In which scans are sent.
  Mirror mirror_;
  unsigned echo_filter_ = 0;
  ScanContent content_;
  std::map<std::string, std::string> kept_;
  Utime clock_offset_ = 0;  // Of the date to the time since it was switched on.
  bool logged_in_ = false, measuring_ = true, subscribed_ = false, first_after_run_ = false;
  std::int64_t next_turn_ = 0, dropped_ = 0;
  double speed_ = 1.0;
  Window window_ = Window::clean;
  std::uint16_t telegrams_ = 0;
};

}  // namespace scanway::simulator
