#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include <Eigen/Geometry>

#include "bot_core/ins_t.hpp"
#include "bot_core/joint_state_t.hpp"
#include "common/bus/bus.h"
#include "common/bus/channels.h"
#include "common/robot/robot.h"
#include "modules/mapper/core/assembly/assembly.h"
#include "modules/mapper/node/line_asker.h"
#include "modules/mapper/node/line_record.h"
#include "modules/mapper/node/raw_channel.h"
#include "modules/mapper/node/sweep_tally.h"
#include "scanway/laser_line_t.hpp"
#include "scanway/sweep_inputs_t.hpp"
#include "scanway/sweep_mark_t.hpp"

namespace scanway {

/// Of the object that an assembled sweep is; its version is the time of its end.
std::string assembled_key(std::int64_t sweep);

/// What a sweep was assembled from, for whoever takes it on SWEEP.
struct SweepOrigin {
  sweep_inputs_t inputs;                            ///< Names the sweep as an object, too.
  std::optional<Eigen::Quaterniond> R_world_sweep;  ///< Over the whole sweep; absent without a tracker.
};

/// The assembler on the bus: LASER_LINE, PAN_TILT_STATE, SWEEP_MARK and IMU in; SWEEP and LINE_REQUEST out. A sweep is
/// made when the pan has ended it and all of its data is there, or so much data time has passed that the rest will not
/// come. It is made of what lies within its time, whatever came first. Its object's key is its name, `sweep_<number>`,
/// its version the time of its end: made again of the same data it is the same object.
class SweepAssembler {
 public:
  /// `assembled` is told of a sweep before its pieces are published. `ask`: request lines that are missing.
  SweepAssembler(Bus& bus, const Robot& robot, std::function<void(SweepOrigin)> assembled, bool ask = true);

  /// Nothing more will come: sweeps that have ended are made of what is there.
  void finish();
  /// Nothing has come for a while (wall time): lines that are missing are asked for once more, a few times; then as
  /// finish().
  void settle();

  /// Whether a sweep is under way, or waits for its data.
  bool busy() const;
  std::size_t news() const { return news_; }  ///< Inputs taken so far.
  std::map<std::string, std::int64_t> counters() const;
  std::string summary() const;  ///< What people should know, in one line; empty: nothing.

 private:
  using Number = std::pair<std::int64_t, std::int64_t>;  // numbered_since, sweep.
  struct OpenSweep {
    std::optional<Utime> started, ended;
    bool ready() const { return started && ended; }
  };
  struct Input {
    RawChannel messages;
    std::int64_t late = 0;
  };

  template <class T>
  void listen(const Channel& channel, void (SweepAssembler::*use)(const T&, const BusMessage&));
  void take_line(const laser_line_t& line, const BusMessage& message);
  void take_angles(const bot_core::joint_state_t& state, const BusMessage& message);
  void take_imu(const bot_core::ins_t& imu, const BusMessage& message);
  void take_mark(const sweep_mark_t& mark, const BusMessage& message);
  void keep(Input& input, Utime utime, const BusMessage& message);
  void drop_never_ended(const Number& but);

  void work();
  void ask_for_lines();
  LineStretches missing_lines(const OpenSweep& sweep) const;
  bool is_complete(const OpenSweep& sweep) const;
  bool is_given_up(const OpenSweep& sweep) const;
  void make(const Number& number, const OpenSweep& sweep);
  void publish(const AssembledSweep& assembled, Utime ended, sweep_inputs_t inputs);
  void forget();

  Bus& bus_;
  const Robot robot_;
  const std::function<void(SweepOrigin)> assembled_;
  const bool ask_;
  Input lines_, angles_, marks_, imu_;
  LineRecord record_;  // Of lines_.
  LineAsker asker_;
  Utime next_ask_ = 0;
  std::map<Number, OpenSweep> open_;
  std::set<Number> done_;     // Made or dropped: their marks are said again and again.
  Utime newest_ = 0;          // Of all channels.
  Utime closed_ = 0;          // The end of the newest sweep that was made.
  bool closed_whole_ = true;  // No line lacked in it.
  int silences_ = 0;          // Since something came.
  std::size_t news_ = 0;
  SweepTally tally_;
  std::int64_t bad_messages_ = 0;
};

}  // namespace scanway
