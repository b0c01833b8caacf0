#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "common/bytes/can_frame.h"
#include "common/math/angle.h"
#include "common/time/utime.h"
#include "modules/simulator/device/pan_tilt/motion_message.h"
#include "modules/simulator/device/pan_tilt/trajectory.h"

namespace scanway::simulator {

/// How a module counts angles: SCHUNK's codes of its unit systems.
enum class MotionUnits : std::uint8_t { radian = 3, degree = 4, microdegree = 7, millidegree = 9 };

/// One axis of a PW-70: radians and seconds.
struct ModuleConfig {
  std::uint8_t id = 11;
  MotionUnits units = MotionUnits::degree;
  double low = radians(-420), high = radians(420);
  double max_speed = radians(360), acceleration = radians(720);
  double reference_speed = radians(60);
  bool referenced = false;  ///< Whether it knows its zero when it is switched on.
  double angle = 0.0;       ///< Where it stands then.
};

/// A module of the PW-70 on the bus: frames in, frames out, its own clock as an argument. (It is not known whether a
/// PW-70 keeps its reference, nor how it counts: both can be chosen.)
class PanTiltModule {
 public:
  explicit PanTiltModule(const ModuleConfig& config);

  /// Frames for others are passed over.
  void receive(const CanFrame& frame, Utime now);
  void tick(Utime now);
  std::vector<CanFrame> take_frames();

  /// Where it truly is, or was in the last seconds.
  double angle(Utime time) const { return trajectory_.angle(time); }
  double speed(Utime time) const { return trajectory_.speed(time); }
  bool referenced() const { return referenced_; }
  /// Its motor goes off with this error (TOW DA, MOTOR VOLTAGE LOW 74, ...).
  void fail(std::uint8_t code, Utime now);
  /// Whether something keeps it from turning: whenever it should, its motor goes off with the error TOW.
  void jam(bool jammed) { jammed_ = jammed; }
  /// Switched off and on: it is silent for `dark`.
  void reboot(Utime now, Utime dark);

 private:
  enum class Activity : std::uint8_t { standing, referencing, to_position, at_speed, braking };

  void power_up(Utime now);
  void obey(const MotionMessage& message, Utime now);
  void obey_move(std::uint8_t command, std::vector<double> values, Utime now);
  void set_target(std::uint8_t command, double value);
  void start_state(const MotionMessage& message, Utime now);
  void get_config(const MotionMessage& message);
  void set_config(const MotionMessage& message);
  void acknowledge();
  void end_of_move(Utime now);
  void watch_limits(Utime now);
  bool beyond(double angle) const { return angle > high_ || angle < low_; }

  void say(const MotionMessage& message, MotionClass who = MotionClass::from_module);
  void say_ok(std::uint8_t command) { say({command, 'O', 'K'}); }
  void refuse(std::uint8_t command, std::uint8_t why) { say({command, why}); }
  void tell_standing(std::uint8_t impulse, Utime now);
  void tell_state(Utime now);
  void append_value(MotionMessage& message, double radians) const;
  std::vector<double> values_of(const MotionMessage& message) const;
  bool whole_numbers() const {
    return config_.units == MotionUnits::microdegree || config_.units == MotionUnits::millidegree;
  }
  double radians_per_unit() const;

  ModuleConfig config_;
  MotionMessages assembler_;
  Trajectory trajectory_;
  Activity activity_ = Activity::standing;
  double low_, high_, speed_, acceleration_;
  bool referenced_, jammed_ = false, impulses_ = true, reached_ = false, moved_ = false;
  std::uint8_t error_ = 0, mask_ = 0;
  Utime boots_until_ = 0, error_repeats_ = 0, next_state_ = 0, state_period_ = 0;
  bool booted_ = false;
  std::vector<CanFrame> frames_;
};

}  // namespace scanway::simulator
