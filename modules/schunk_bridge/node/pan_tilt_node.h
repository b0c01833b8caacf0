#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "common/bus/bus.h"
#include "modules/schunk_bridge/core/pan_tilt.h"
#include "scanway/pan_tilt_command_t.hpp"

namespace scanway::schunk {

/// The pan-tilt on the bus: PAN_TILT_COMMAND in; PAN_TILT_STATE and SWEEP_MARK out. A turn of the bridge is obey(), the
/// device's turn, tell(). A command that comes again with the same time is the same
/// one, unless it is a stop.
class PanTiltNode {
 public:
  /// Both must outlive this. `started`: when the numbering of the sweeps begins.
  PanTiltNode(Bus& bus, PanTilt& pan_tilt, Utime started);

  /// Carries out what was commanded since the last time. Returns whether anything was.
  bool obey(Utime now);
  /// Publishes where the axes were and what happened since the last time.
  void tell(Utime now);
  /// Stops what moves. Returns false when nothing does.
  bool stop_moving(Utime now);

  std::map<std::string, std::int64_t> counters() const;
  /// What is wrong, in one line; empty: nothing.
  std::string summary(Utime now) const;

 private:
  using Command = pan_tilt_command_t;

  void take(const BusMessage& message);
  bool is_repetition(const Command& command) const;
  void publish_state(const AxisState& pan);
  void handle(const Event& event);
  void publish_mark(const Event& event, std::int8_t mark);

  Bus& bus_;
  PanTilt& pan_tilt_;
  const SweepConfig configured_;
  const Utime started_;
  std::vector<Command> waiting_;
  Command last_command_{};
  std::string last_refusal_;  // Of the last command; empty: it was not refused.
  Utime refused_at_ = 0;
  Utime last_state_ = 0;
  std::int64_t commands_ = 0, refused_ = 0, bad_messages_ = 0, states_ = 0, state_gaps_ = 0, errors_ = 0;
  std::int64_t sweeps_ended_ = 0, sweeps_aborted_ = 0;
};

}  // namespace scanway::schunk
