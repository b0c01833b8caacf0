#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "modules/schunk_bridge/core/axis.h"
#include "modules/schunk_bridge/core/event.h"

namespace scanway::schunk {

/// Radians, radians a second.
struct SweepConfig {
  double start = radians(-180);       ///< The pan angle at which it begins.
  double angle = radians(360);        ///< How far it goes; may be negative.
  double speed = radians(3);          ///< While it scans.
  double travel_speed = radians(30);  ///< To its start, back from its end, and of the tilt.
  double tilt = 0;                    ///< The tilt angle that is held.
  bool reference_if_needed = true;    ///< Axes that do not know their zero look for it first.
};

/// The sweep as one command: both axes to their reference if need be, tilt to its angle, pan to the start, then the
/// sweep at its constant speed, then the pan back. Its events mark where the scan begins and ends.
class Sweep {
 public:
  /// Both axes must outlive this.
  Sweep(const SweepConfig& config, Axis& pan, Axis& tilt) : config_(config), pan_(pan), tilt_(tilt) {}

  /// Returns why it is refused, or nothing.
  std::string start(Utime now);
  /// After every step of the axes.
  void advance(Utime now);
  /// Ends it where it is; the axes are the caller's to stop.
  void cancel(const std::string& reason, Utime now);

  void set_config(const SweepConfig& config) { config_ = config; }  ///< For the next sweep.
  const SweepConfig& config() const { return config_; }
  const SweepConfig& active_config() const { return active_config_; }  ///< Of the present or last sweep.
  bool active() const { return phase_ != Phase::idle; }
  bool scanning() const { return phase_ == Phase::scanning && pan_.motion().accepted(); }
  std::int64_t number() const { return number_; }  ///< Of the present or last sweep, from 1; 0: none yet.
  std::vector<Event> take_events();

 private:
  enum class Phase : std::uint8_t { idle, referencing_tilt, referencing_pan, placing, settling, scanning, returning };

  std::string why_not(const Axis& axis) const;
  void go_on(Utime now);
  void enter(Phase phase, Utime now);
  void follow_scan(Utime now);
  void abort(const std::string& reason, Utime now);
  void tell(Event::Kind kind, Utime utime, const std::string& text, const std::string& reason = {});
  double travel_speed(const Axis& axis) const;
  double end() const { return active_config_.start + active_config_.angle; }

  SweepConfig config_, active_config_;
  Axis& pan_;
  Axis& tilt_;
  Phase phase_ = Phase::idle;
  std::int64_t number_ = 0;
  Utime since_ = 0;  // Of the present phase.
  bool started_ = false;
  std::vector<Event> events_;
};

}  // namespace scanway::schunk
