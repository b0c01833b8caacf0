#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "common/math/angle.h"
#include "common/time/utime.h"
#include "modules/schunk_bridge/core/conversation.h"
#include "modules/schunk_bridge/core/event.h"
#include "modules/schunk_bridge/core/motion.h"

namespace scanway::schunk {

/// One axis of the pan-tilt: radians, radians a second.
struct AxisConfig {
  std::string name = "pan";
  std::uint8_t module = 11;
  double low = radians(-420), high = radians(420);  ///< The module's own software limits may be closer.
  double max_speed = radians(360);
  double acceleration = 0;       ///< Radians/s^2, set at the start; 0: as the module has it.
  double state_period_s = 0.02;  ///< How often the module tells where it is.
  bool ask_velocity = true;      ///< Its state then takes two frames instead of one.
};

/// Where an axis is, as it said itself.
struct AxisState {
  Utime utime = 0;  ///< When its (first) frame came.
  double position = 0;
  std::optional<double> velocity;
  std::uint8_t bits = 0;   ///< state_bit
  std::uint8_t error = 0;  ///< 0: none.
};

/// What went wrong below the level of commands, since the start.
struct AxisCounters {
  std::uint64_t bad_frames = 0;
  std::uint64_t times_lost = 0;
};

/// One module of the pan-tilt as a state machine: frames in, frames out, the time is an argument. It finds its module,
/// reads how it counts (unit system, limits), has it tell its state in a fixed rhythm, and finds it again after a
/// restart or a silence. It moves nothing unasked.
class Axis {
 public:
  enum class Phase : std::uint8_t {
    absent,      ///< No answer yet, or no longer.
    setting_up,  ///< It answers.
    ready,       ///< It tells its state and takes commands.
    unusable,    ///< It answers, but is no axis that can be used: see the last `refused` event.
  };

  explicit Axis(AxisConfig config);

  /// Frames of other modules are passed over.
  void receive(const CanFrame& frame, Utime now);
  void tick(Utime now);
  std::optional<CanFrame> next_frame(Utime now) { return conversation_.next_frame(now); }
  bool urgent() const { return conversation_.urgent(); }
  /// The clock has been set back: what was measured by it counts from now. After a stop.
  void clock_was_set(Utime now);
  /// The interface dropped frames: what was put together of fragments is not to be trusted.
  void frames_lost();

  // Commands. They return why they are refused, in one line, or nothing when they are on their way.
  std::string reference(Utime now);
  std::string move_to(double position, double speed, Utime now);
  /// Turns until it is stopped, at its limits at the latest.
  std::string move_at(double speed, Utime now);
  /// Brakes to a stand.
  void stop();
  /// The motor goes off at once; acknowledge() before it can move again.
  void fast_stop();
  std::string acknowledge();

  const AxisConfig& config() const { return config_; }
  Phase phase() const { return phase_; }
  const std::optional<AxisState>& state() const { return state_; }
  /// The states that it told since the last call, in order; of very many, the last ones.
  std::vector<AxisState> take_states();
  const Motion& motion() const { return motion_; }
  const AxisCounters& counters() const { return counters_; }
  bool referenced() const { return state_ && (state_->bits & state_bit::kReferenced) != 0; }
  /// Code of the error that keeps it from moving; 0: none.
  std::uint8_t error() const { return error_; }
  /// The angles that it may go to.
  double low() const { return low_; }
  double high() const { return high_; }
  double max_speed() const { return max_speed_; }
  /// What it says of itself, once known: "PW-70, firmware 1.21, deg, -420 to 420 deg".
  std::string description() const;
  std::vector<Event> take_events();

 private:
  void begin_setup(Utime now);
  void ask_for_units(Utime now);
  void ask_for_state();
  void take(const Message& message, Utime now);
  void take_alert(const Message& message, const reply::Alert& alert, Utime now);
  void take_state(const reply::State& state, Utime utime, Utime now);
  void take_standing(double position, Utime utime, Utime now);
  void take_answer(const Asked& asked, const Reply& reply, Utime now);
  void take_setting(const reply::SettingValue& value);
  void take_units(const reply::SettingValue& value, Utime now);
  void take_failure(const Asked& asked, std::uint8_t code, Utime now);
  void take_silence(const Asked& asked, Utime now);
  void set_error(std::uint8_t code, Utime now);
  void clear_error(Utime now);
  void lose(const std::string& why, Utime now);
  void report_motion(Motion::Change change, Utime now);
  void watch_limits(Utime now);
  std::string why_no_move() const;
  std::string why_not_at(double speed) const;
  void tell(Event::Kind kind, Utime now, std::string text, std::uint8_t code = 0);
  double to_radians(double value) const { return value * scale_; }
  double from_radians(double angle) const { return angle / scale_; }

  AxisConfig config_;
  Phase phase_ = Phase::absent;
  Conversation conversation_;
  MessageAssembler assembler_;
  UnitSystem units_ = UnitSystem::radian;
  double scale_ = 1.0;  // Radians per unit.
  double low_, high_, max_speed_;
  std::optional<reply::ModuleInfo> info_;
  std::optional<AxisState> state_;
  std::vector<AxisState> states_;  // Not taken yet.
  double turning_at_ = 0;          // The commanded speed, with its sign.
  std::uint8_t error_ = 0;
  Utime error_utime_ = 0;  // When it was reported last.
  std::uint8_t warning_ = 0;
  Motion motion_;
  std::optional<Utime> since_;       // Of the present phase.
  std::optional<Utime> asked_last_;  // While absent.
  bool told_absence_ = false;
  bool told_refusal_ = false;  // Of a request of the set-up.
  AxisCounters counters_;
  std::vector<Event> events_;
};

}  // namespace scanway::schunk
