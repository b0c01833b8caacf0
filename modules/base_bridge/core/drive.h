#pragma once

#include <deque>
#include <optional>

#include "common/math/angle.h"
#include "common/time/utime.h"
#include "modules/base_bridge/core/command.h"

namespace scanway::erratic {

/// No watchdog of the robot is known, so all of these are ours.
struct DriveConfig {
  double max_speed_m_s = 2.0;
  double max_turn_rate_rad_s = radians(360);
  Utime lifetime = 150'000;          ///< Of a command: then the robot is told to stop.
  Utime motors_off_after = 250'000;  ///< The last command: then its motors lose power.
  Utime repeat_period = 100'000;     ///< A velocity that is valid is sent again.
  Utime pulse_period = 1'000'000;    ///< Sign of life while nothing moves.
};

/// What the robot is told about its motion: velocities that run out, and stops, one packet after the other.
class Drive {
 public:
  explicit Drive(const DriveConfig& config) : config_(config) {}

  /// A command. Speeds beyond the limits are slowed down together, so that the curve stays the same.
  void set(double speed_m_s, double turn_rate_rad_s, Utime now);
  /// Stand still, now; motors off after their time.
  void stop(Utime now);
  /// Forgets everything that was under way, stands still and takes the power off the motors, in case anybody hears it.
  void shut_down(Utime now);
  /// The robot is known to stand without power.
  void reset();
  /// The clock has been set back: what was commanded before it has run out.
  void clock_was_set(Utime now);
  /// Returns true when a command has just run out.
  bool tick(Utime now);

  bool empty() const { return packets_.empty(); }
  Packet take();
  bool moving() const { return valid_; }
  bool motors_on() const { return motors_on_; }

 private:
  void send_velocity(Utime now);
  void halt(Utime now);

  DriveConfig config_;
  std::deque<Packet> packets_;
  int speed_mm_s_ = 0, turn_rate_deg_s_ = 0;
  bool valid_ = false;      // A velocity is being held.
  bool changed_ = false;    // It has not been sent yet.
  bool motors_on_ = false;  // As far as the robot has been told.
  Utime commanded_ = 0;     // The last command.
  std::optional<Utime> velocity_sent_;
  Utime pulse_sent_ = 0;
};

}  // namespace scanway::erratic
