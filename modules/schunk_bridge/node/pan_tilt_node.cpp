#include "modules/schunk_bridge/node/pan_tilt_node.h"

#include <spdlog/spdlog.h>

#include <limits>
#include <utility>

#include "bot_core/joint_state_t.hpp"
#include "common/bus/channels.h"
#include "common/messages/bad_message.h"
#include "common/messages/codec.h"
#include "modules/schunk_bridge/node/commands.h"
#include "scanway/sweep_mark_t.hpp"

namespace scanway::schunk {
namespace {

/// How long a refusal stands in the summary.
constexpr Utime kRefusalShown = 10 * kMicrosecondsPerSecond;
constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();

bool is_trouble(const Event& event) {
  switch (event.kind) {
    case Event::Kind::lost:
    case Event::Kind::booted:
    case Event::Kind::blocked:
    case Event::Kind::refused:
    case Event::Kind::error:
    case Event::Kind::warning:
    case Event::Kind::sweep_aborted:
      return true;
    default:
      return false;
  }
}

void add_to(std::string& summary, const std::string& sentence) {
  if (!sentence.empty()) summary += (summary.empty() ? "" : "; ") + sentence;
}

std::string trouble_of(const Axis& axis) {
  const std::string& name = axis.config().name;
  if (axis.phase() == Axis::Phase::unusable) return name + " cannot be used as it is set up";
  if (axis.phase() != Axis::Phase::ready) return name + " does not answer";
  return axis.error() == 0 ? std::string() : name + " has error " + describe_code(axis.error());
}

}  // namespace

PanTiltNode::PanTiltNode(Bus& bus, PanTilt& pan_tilt, Utime started)
    : bus_(bus), pan_tilt_(pan_tilt), configured_(pan_tilt.sweep().config()), started_(started) {
  bus_.subscribe(channel::kPanTiltCommand.name, [this](const BusMessage& message) { take(message); });
}

void PanTiltNode::take(const BusMessage& message) {
  try {
    waiting_.push_back(decode<Command>(message.bytes));
  } catch (const BadMessage&) {
    ++bad_messages_;
  }
}

bool PanTiltNode::is_repetition(const Command& command) const {
  if (command.command == Command::STOP || command.command == Command::FAST_STOP) return false;  // Never once too often.
  return command.utime == last_command_.utime && command.command == last_command_.command && commands_ > 0;
}

bool PanTiltNode::obey(Utime now) {
  const std::int64_t before = commands_;
  for (const Command& command : std::exchange(waiting_, {})) {
    if (is_repetition(command)) continue;
    ++commands_;
    last_command_ = command;
    last_refusal_ = carry_out(command, pan_tilt_, configured_, now);
    if (last_refusal_.empty()) {
      spdlog::info("{}", command_name(command.command));
      continue;
    }
    ++refused_;
    refused_at_ = now;
    last_refusal_ = command_name(command.command) + " refused: " + last_refusal_;
    spdlog::warn("{}", last_refusal_);
  }
  return commands_ != before;
}

void PanTiltNode::tell(Utime) {
  for (const AxisState& pan : pan_tilt_.take_pan_states()) publish_state(pan);
  pan_tilt_.take_tilt_states();
  for (const Event& event : pan_tilt_.take_events()) handle(event);
}

void PanTiltNode::publish_state(const AxisState& pan) {
  // The tilt is held while it matters: its newest angle does for any time near.
  const auto& tilt = pan_tilt_.tilt().state();
  if (!tilt) return;
  const auto period = static_cast<Utime>(pan_tilt_.pan().config().state_period_s * 1e6);
  if (states_ > 0 && pan.utime - last_state_ > period + period / 2) ++state_gaps_;
  last_state_ = pan.utime;
  ++states_;
  bot_core::joint_state_t message{};
  message.utime = pan.utime;
  message.num_joints = 2;
  message.joint_name = {"pan", "tilt"};
  message.joint_position = {static_cast<float>(pan.position), static_cast<float>(tilt->position)};
  for (const auto& velocity : {pan.velocity, tilt->velocity}) {
    message.joint_velocity.push_back(velocity ? static_cast<float>(*velocity) : kUnknown);
  }
  message.joint_effort = {kUnknown, kUnknown};
  bus_.publish(channel::kPanTiltState.name, encode(message), message.utime);
}

void PanTiltNode::handle(const Event& event) {
  spdlog::log(is_trouble(event) ? spdlog::level::warn : spdlog::level::info, "{}", event.text);
  switch (event.kind) {
    case Event::Kind::error:
      ++errors_;
      return;
    case Event::Kind::sweep_started:
      return publish_mark(event, sweep_mark_t::STARTED);
    case Event::Kind::sweep_ended:
      ++sweeps_ended_;
      return publish_mark(event, sweep_mark_t::ENDED);
    case Event::Kind::sweep_aborted:
      ++sweeps_aborted_;
      return publish_mark(event, sweep_mark_t::ABORTED);
    default:
      return;
  }
}

void PanTiltNode::publish_mark(const Event& event, std::int8_t mark) {
  const SweepConfig& sweep = pan_tilt_.sweep().active_config();
  sweep_mark_t message{};
  message.utime = event.utime;
  message.sweep = event.sweep;
  message.numbered_since = started_;
  message.mark = mark;
  message.pan_rad = event.position;
  const auto& tilt = pan_tilt_.tilt().state();
  message.tilt_rad = tilt ? tilt->position : std::numeric_limits<double>::quiet_NaN();
  message.pan_speed_rad_s = sweep.speed;
  message.sweep_angle_rad = sweep.angle;
  message.reason = event.reason;
  bus_.publish(channel::kSweepMark.name, encode(message), message.utime);
}

bool PanTiltNode::stop_moving(Utime now) {
  const bool moves = pan_tilt_.pan().motion().under_way() || pan_tilt_.tilt().motion().under_way();
  if (moves || pan_tilt_.sweep().active()) pan_tilt_.stop(now);
  return moves;
}

std::map<std::string, std::int64_t> PanTiltNode::counters() const {
  const auto sum = [this](std::uint64_t AxisCounters::*what) {
    return static_cast<std::int64_t>(pan_tilt_.pan().counters().*what + pan_tilt_.tilt().counters().*what);
  };
  return {{"schunk_commands", commands_},
          {"schunk_commands_refused", refused_},
          {"schunk_last_command", last_command_.utime},
          {"schunk_last_command_refused", last_refusal_.empty() ? 0 : 1},
          {"schunk_bad_messages", bad_messages_},
          {"schunk_states", states_},
          {"schunk_state_gaps", state_gaps_},
          {"schunk_bad_frames", sum(&AxisCounters::bad_frames)},
          {"schunk_times_lost", sum(&AxisCounters::times_lost)},
          {"schunk_errors", errors_},
          {"schunk_sweep", pan_tilt_.sweep().number()},
          {"schunk_sweeps_ended", sweeps_ended_},
          {"schunk_sweeps_aborted", sweeps_aborted_}};
}

std::string PanTiltNode::summary(Utime now) const {
  std::string summary;
  if (!last_refusal_.empty() && now - refused_at_ < kRefusalShown) summary = last_refusal_;
  add_to(summary, trouble_of(pan_tilt_.pan()));
  add_to(summary, trouble_of(pan_tilt_.tilt()));
  return summary;
}

}  // namespace scanway::schunk
