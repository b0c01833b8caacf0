#include "modules/mapper/node/sweep_assembler.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "common/messages/codec.h"
#include "common/messages/digest.h"
#include "common/messages/imu_message.h"
#include "common/messages/objects.h"
#include "common/messages/sweep_message.h"
#include "modules/mapper/node/raw_input.h"

namespace scanway {
namespace {

/// Data that is not asked for again comes within this, or not at all.
constexpr Utime kBound = kMicrosecondsPerSecond;
/// Lines are asked for again, for most of the minute that the bridge keeps them.
constexpr Utime kLineBound = 40 * kMicrosecondsPerSecond;
constexpr Utime kAskEvery = 50'000;
constexpr Utime kBeforeStart = 2 * kMicrosecondsPerSecond;
constexpr Utime kHistory = 300 * kMicrosecondsPerSecond;  // Kept outside sweeps: the marks may come late.
constexpr Utime kMaxUtime = Utime{1} << 60;               // Messages say what they like; sums must not overflow.
constexpr std::size_t kMostLineBytes = std::size_t{256} << 20;
constexpr std::size_t kMostDone = 1000;
constexpr int kMostSilences = 5;

}  // namespace

std::string assembled_key(std::int64_t sweep) { return fmt::format("sweep_{}", sweep); }

SweepAssembler::SweepAssembler(Bus& bus, const Robot& robot, std::function<void(SweepOrigin)> assembled, bool ask)
    : bus_(bus), robot_(robot), assembled_(std::move(assembled)), ask_(ask), lines_{RawChannel(kMostLineBytes)} {
  listen(channel::kImu, &SweepAssembler::take_imu);
  listen(channel::kPanTiltState, &SweepAssembler::take_angles);
  listen(channel::kLaserLine, &SweepAssembler::take_line);
  listen(channel::kSweepMark, &SweepAssembler::take_mark);
}

template <class T>
void SweepAssembler::listen(const Channel& channel, void (SweepAssembler::*use)(const T&, const BusMessage&)) {
  bus_.subscribe(channel.name, [this, use](const BusMessage& bytes) {
    try {
      const T message = decode<T>(bytes.bytes);
      if (message.utime < 0 || message.utime > kMaxUtime) throw BadMessage("a time that is none");
      (this->*use)(message, bytes);
      work();
    } catch (const BadMessage&) {
      ++bad_messages_;
    }
  });
}

void SweepAssembler::keep(Input& input, Utime utime, const BusMessage& message) {
  ++news_;
  silences_ = 0;
  if (!input.messages.add(utime, message.bytes)) return;
  newest_ = std::max(newest_, utime);
  if (utime <= closed_ && !(&input == &lines_ && closed_whole_)) ++input.late;
  forget();
}

void SweepAssembler::take_line(const laser_line_t& line, const BusMessage& message) {
  if (line.echo != 0) return;
  record_.add(line);
  keep(lines_, line.utime, message);
}

void SweepAssembler::take_angles(const bot_core::joint_state_t& state, const BusMessage& message) {
  keep(angles_, angles_of(state).utime, message);
}

void SweepAssembler::take_imu(const bot_core::ins_t& imu, const BusMessage& message) {
  orientation_of(imu);
  keep(imu_, imu.utime, message);
}

void SweepAssembler::take_mark(const sweep_mark_t& mark, const BusMessage& message) {
  const Number number{mark.numbered_since, mark.sweep};
  if (done_.contains(number)) return;
  if (mark.mark != sweep_mark_t::STARTED && mark.mark != sweep_mark_t::ENDED && mark.mark != sweep_mark_t::ABORTED) {
    throw BadMessage("SWEEP_MARK that marks nothing");
  }
  keep(marks_, mark.utime, message);
  if (mark.mark == sweep_mark_t::ABORTED) {
    tally_.given_up(assembled_key(mark.sweep), mark.reason);
    done_.insert(number);
    open_.erase(number);
    return;
  }
  OpenSweep& sweep = open_[number];
  (mark.mark == sweep_mark_t::STARTED ? sweep.started : sweep.ended) = mark.utime;
  if (mark.mark == sweep_mark_t::STARTED) drop_never_ended(number);
}

/// The pan-tilt makes one sweep after the other.
void SweepAssembler::drop_never_ended(const Number& but) {
  const Utime started = *open_.at(but).started;
  for (auto one = open_.begin(); one != open_.end();) {
    const auto& [number, sweep] = *one;
    const bool ends = sweep.ended || !sweep.started || *sweep.started >= started;
    if (!ends) {
      tally_.never_ended(assembled_key(number.second));
      done_.insert(number);
    }
    one = ends ? std::next(one) : open_.erase(one);
  }
}

bool SweepAssembler::busy() const {
  return std::any_of(open_.begin(), open_.end(), [](const auto& one) { return one.second.started.has_value(); });
}

void SweepAssembler::work() {
  if (newest_ >= next_ask_) {
    ask_for_lines();
    next_ask_ = newest_ + kAskEvery;
  }
  for (auto one = open_.begin(); one != open_.end();) {
    const auto [number, sweep] = *one++;
    if (sweep.ready() && (is_complete(sweep) || is_given_up(sweep))) make(number, sweep);
    if (!sweep.started && newest_ > *sweep.ended + kLineBound) {
      tally_.never_started();
      done_.insert(number);
      open_.erase(number);
    }
  }
}

void SweepAssembler::finish() {
  for (auto one = open_.begin(); one != open_.end();) {
    const auto [number, sweep] = *one++;
    if (sweep.ready()) make(number, sweep);
  }
}

void SweepAssembler::settle() {
  asker_.hurry();
  ask_for_lines();
  const bool hopeless = std::all_of(open_.begin(), open_.end(), [this](const auto& one) {
    return !one.second.ready() || missing_lines(one.second).empty();
  });
  if (hopeless || !ask_ || ++silences_ > kMostSilences) finish();
}

void SweepAssembler::ask_for_lines() {
  if (!ask_) return;
  for (const auto& [number, sweep] : open_) {
    if (!sweep.started) continue;
    const auto request = asker_.ask(missing_lines(sweep), record_.numbered_since(), newest_);
    if (request) bus_.publish(channel::kLineRequest.name, encode(*request), request->utime);
  }
}

LineStretches SweepAssembler::missing_lines(const OpenSweep& sweep) const {
  return record_.missing({*sweep.started, sweep.ended}, newest_, silences_ > 0);
}

bool SweepAssembler::is_complete(const OpenSweep& sweep) const {
  const Utime ended = *sweep.ended;
  const auto reaches = [&](const Input& input) { return input.messages.newest().value_or(0) >= ended; };
  return reaches(angles_) && reaches(imu_) && record_.reaches(ended) && record_.last_is_whole(ended) &&
         missing_lines(sweep).empty();
}

bool SweepAssembler::is_given_up(const OpenSweep& sweep) const {
  if (newest_ <= *sweep.ended + kBound) return false;
  return newest_ > *sweep.ended + kLineBound || missing_lines(sweep).empty();
}

void SweepAssembler::make(const Number& number, const OpenSweep& sweep) {
  done_.insert(number);
  open_.erase(number);
  while (done_.size() > kMostDone) done_.erase(done_.begin());
  const Utime started = *sweep.started, ended = *sweep.ended;
  const auto lines = lines_.messages.from_to(started - LineRecord::kLongestLine, ended);
  const auto angles = angles_.messages.around(started, ended);
  const auto imu = imu_.messages.from_to(started, ended);
  const auto marks = marks_.messages.from_to(started, ended);

  AssemblyInput input = assembly_input(lines, angles, imu);
  input.sweep = number.second;
  input.started = started;
  input.ended = ended;
  const AssembledSweep assembled = assemble(input, robot_);
  tally_.made(assembled);

  sweep_inputs_t inputs{};
  inputs.inputs = {
      span_of(channel::kImu.name, imu, imu_.late), span_of(channel::kPanTiltState.name, angles, angles_.late),
      span_of(channel::kLaserLine.name, lines, lines_.late), span_of(channel::kSweepMark.name, marks, marks_.late)};
  inputs.ninputs = static_cast<std::int16_t>(inputs.inputs.size());
  closed_whole_ = assembled.report.missing_lines == 0 && assembled.report.missing_beams == 0;
  closed_ = std::max(closed_, ended);
  if (assembled.report.points > 0) publish(assembled, ended, std::move(inputs));
  forget();
}

void SweepAssembler::publish(const AssembledSweep& assembled, Utime ended, sweep_inputs_t inputs) {
  const Sweep& sweep = assembled.sweep;
  const auto bytes = encode(sweep);
  inputs.utime = sweep.utime;
  inputs.sweep_name = sweep.name;
  inputs.sweep_digest = static_cast<std::int64_t>(digest(bytes));
  assembled_({std::move(inputs), sweep.R_world_sweep});
  publish_object(bus_, channel::kSweep, bytes, sweep.name, ended, sweep.utime);
}

/// What no sweep will be made of any more.
void SweepAssembler::forget() {
  const auto floor = [this](const Input& input) {
    const Utime history = busy() ? 0 : input.messages.newest().value_or(0) - kHistory;
    return std::max(closed_, history) - kBeforeStart;
  };
  for (Input* input : {&imu_, &angles_, &lines_, &marks_}) input->messages.forget_before(floor(*input));
  record_.forget_before(floor(lines_));
  if (const auto first = record_.first()) asker_.forget_before(*first);
}

std::map<std::string, std::int64_t> SweepAssembler::counters() const {
  std::map<std::string, std::int64_t> all = tally_.counters();
  all.merge(std::map<std::string, std::int64_t>{
      {"assembler_line_requests", asker_.requests()},
      {"assembler_lines_asked", asker_.lines_asked()},
      {"assembler_repeated_pieces", static_cast<std::int64_t>(record_.repeated_pieces())},
      {"assembler_late_lines", lines_.late},
      {"assembler_late_angles", angles_.late},
      {"assembler_late_marks", marks_.late},
      {"assembler_late_imu", imu_.late},
      {"assembler_bad_messages", bad_messages_}});
  return all;
}

std::string SweepAssembler::summary() const {
  std::vector<std::string> sentences;
  for (const auto& [number, sweep] : open_) {
    if (!sweep.started) continue;
    const std::string name = assembled_key(number.second);
    sentences.push_back(sweep.ended ? name + " waits for its data" : name + " is under way");
  }
  if (!tally_.note().empty()) sentences.push_back(tally_.note());
  return fmt::format("{}", fmt::join(sentences, "; "));
}

}  // namespace scanway
