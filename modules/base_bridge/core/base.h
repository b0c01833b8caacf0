#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "common/math/angle.h"
#include "common/time/utime.h"
#include "modules/base_bridge/core/command.h"
#include "modules/base_bridge/core/drive.h"
#include "modules/base_bridge/core/odometry.h"
#include "modules/base_bridge/core/report.h"

namespace scanway::erratic {

struct BaseConfig {
  DriveConfig drive;
  /// Limits for the robot; 0: it keeps its own.
  int max_acceleration_mm_s2 = 0, max_turn_acceleration_deg_s2 = 0;
  bool sonar = false, analog = false;  ///< Whether to ask for these reports.
  Utime silence = 2'000'000;           ///< Without any packet for this long the robot counts as lost.
};

/// Something that happened, for the bus, the health and the log.
struct BaseEvent {
  enum class Kind : std::uint8_t { found, lost, odometry_gap, stalled, motors_off, text };
  Kind kind{};
  Utime utime = 0;
  std::string text;  ///< One line for people.
};

struct BaseCounters {
  std::uint64_t packets = 0, bad_bytes = 0, malformed = 0, dropped_steps = 0, times_lost = 0;
};

/// The ERA-Mobi base as a state machine: bytes in, packets out, the time is an argument.
///
///   set the port to baud(); receive() what comes; tick(); write what next_packet() gives; then take_events().
///
/// Call tick() at least every 10 ms. It finds the robot's baud rate, asks what it is, opens its controller, stops
/// whatever it was doing, and follows its odometry. Velocities run out (DriveConfig), and then the motors go off.
class Base {
 public:
  explicit Base(const BaseConfig& config = {});

  void receive(Bytes bytes, Utime now);
  void tick(Utime now);
  /// The next packet to write, at least 15 ms after the one before; empty: nothing now.
  Packet next_packet(Utime now);
  int baud() const { return kBauds[baud_]; }
  /// The port was opened anew: the search begins again, at the rate that was right last.
  void port_opened(Utime now);

  /// Drives at this speed until the next command, at most for the command's lifetime. Returns why it is refused, or
  /// nothing.
  std::string drive(double speed_m_s, double turn_rate_rad_s, Utime now);
  void stop(Utime now) { drive_.stop(now); }
  /// What to write before the port is closed.
  static std::vector<Packet> farewell();

  bool motors_on() const { return drive_.motors_on(); }
  bool stalled() const { return stalled_; }
  bool ready() const { return phase_ == Phase::running && has_pose_; }
  const WheelPose& pose() const { return odometry_.pose(); }
  const std::optional<MotorReport>& motors() const { return motors_; }
  const std::optional<ConfigurationReport>& configuration() const { return configuration_; }
  /// The reports other than motor's that came since the last call.
  std::vector<Report> take_reports();
  std::vector<BaseEvent> take_events();
  const BaseCounters& counters() const { return counters_; }

 private:
  enum class Phase : std::uint8_t { searching, identifying, running };
  static constexpr int kBauds[] = {38400, 115200};

  void take(const Report& report, Utime now);
  void take_motors(const MotorReport& report, Utime now);
  void search(Utime now);
  void open(Utime now);
  void watch_clock(Utime now);
  void tell(BaseEvent::Kind kind, Utime now, std::string text);

  BaseConfig config_;
  FrameFinder finder_;
  Phase phase_ = Phase::searching;
  Drive drive_;
  Odometry odometry_;
  std::size_t baud_ = 0;
  std::optional<Utime> since_;  // Of the present phase; while searching, of the present baud rate.
  std::optional<Utime> asked_, sent_;
  Utime heard_ = 0;  // The last whole packet.
  Utime ticked_ = 0;
  std::uint64_t bytes_while_searching_ = 0;
  bool told_absence_ = false, has_pose_ = false, stalled_ = false;
  int bauds_tried_ = 0;
  std::deque<Packet> opening_;
  std::optional<MotorReport> motors_;
  std::optional<ConfigurationReport> configuration_;
  std::vector<Report> reports_;
  BaseCounters counters_;
  std::vector<BaseEvent> events_;
};

}  // namespace scanway::erratic
