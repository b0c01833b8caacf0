#pragma once

#include <optional>
#include <string>
#include <vector>

#include "modules/schunk_bridge/core/axis.h"
#include "modules/schunk_bridge/core/sweep.h"

namespace scanway::schunk {

struct PanTiltConfig {
  AxisConfig pan;
  AxisConfig tilt{"tilt", 12, radians(-120), radians(120), 4.1, 0, 0.02, true};
  SweepConfig sweep;
};

/// The PW-70: two axes on one bus, and the sweep. Frames in, frames out, the time is an argument:
///
///   for every frame that came: receive(); then tick(); then send while next_frame() gives one; then take_events().
///
/// Call tick() at least every 10 ms. Commands return why they are refused, in one line, or nothing.
class PanTilt {
 public:
  /// Throws std::invalid_argument when the two modules have the same id or an id that is none.
  explicit PanTilt(const PanTiltConfig& config);
  PanTilt(const PanTilt&) = delete;
  PanTilt& operator=(const PanTilt&) = delete;

  void receive(const CanFrame& frame, Utime now);
  void tick(Utime now);
  /// What is to be sent now: stops first, the axes in turn, a millisecond between two frames.
  std::optional<CanFrame> next_frame(Utime now);
  /// The interface dropped received frames.
  void frames_lost();

  /// One sweep of the pan, and back. Another speed or tilt than configured: set_config() of sweep().
  std::string start_sweep(Utime now) { return sweep_.start(now); }
  std::string move_pan(double position, double speed, Utime now);
  std::string move_tilt(double position, double speed, Utime now);
  std::string turn_pan(double speed, Utime now);
  std::string turn_tilt(double speed, Utime now);
  /// Sends the axes that do not know their zero, one after the other, to look for it.
  std::string reference(Utime now);
  /// Both axes brake to a stand; a sweep is over.
  void stop(Utime now);
  /// Both motors go off at once; acknowledge() before they move again.
  void fast_stop(Utime now);
  std::string acknowledge();

  const Axis& pan() const { return pan_; }
  const Axis& tilt() const { return tilt_; }
  /// Where they were since the last call (Axis::take_states).
  std::vector<AxisState> take_pan_states() { return pan_.take_states(); }
  std::vector<AxisState> take_tilt_states() { return tilt_.take_states(); }
  const Sweep& sweep() const { return sweep_; }
  Sweep& sweep() { return sweep_; }
  std::vector<Event> take_events();

 private:
  void watch_clock(Utime now);
  bool busy() const { return sweep_.active(); }

  Axis pan_, tilt_;
  Sweep sweep_;
  bool reference_pan_next_ = false;
  bool pan_turn_ = true;
  std::optional<Utime> sent_;
  Utime ticked_ = 0;
};

}  // namespace scanway::schunk
