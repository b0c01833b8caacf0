#include "modules/replay/replay.h"

#include <set>
#include <utility>

#include "common/bus/channels.h"
#include "common/config/robot_file.h"
#include "common/files/input_error.h"
#include "common/files/printable.h"
#include "common/messages/bad_message.h"
#include "common/messages/codec.h"
#include "common/messages/object_assembler.h"
#include "common/messages/objects.h"
#include "common/messages/params_message.h"
#include "common/messages/rigid.h"
#include "scanway/laser_line_t.hpp"
#include "scanway/reference_pose_t.hpp"
#include "scanway/sweep_inputs_t.hpp"
#include "scanway/sweep_mark_t.hpp"

namespace scanway {
namespace {

/// What a robot measures and people ask for. All else in a log is derived from it.
constexpr const Channel* kInputs[] = {&channel::kImu,       &channel::kPanTiltState,  &channel::kLaserLine,
                                      &channel::kSweepMark, &channel::kReferencePose, &channel::kSweep,
                                      &channel::kGoal,      &channel::kMapCommand};
/// The key of a live mapper's own PARAMS; an imported log's is kParamsKey.
constexpr const char* kMapper = "mapper";
/// The name that scanway-simulator gives to its robot's pose, which it says once a second.
constexpr const char* kSimulator = "simulator";

bool is_input(std::string_view name) {
  for (const Channel* input : kInputs) {
    if (input->name == name) return true;
  }
  return false;
}

void note(const sweep_inputs_t& inputs, ListedOrientations& listed) {
  std::optional<std::uint64_t> imu;
  for (const input_span_t& input : inputs.inputs) {
    if (input.channel != channel::kImu.name) continue;
    if (input.used_count > 1) return;  // Of an assembled sweep, whose orientation no single message has.
    if (input.used_count == 1) imu = static_cast<std::uint64_t>(input.used_digest);
  }
  listed[static_cast<std::uint64_t>(inputs.sweep_digest)] = imu;
}

/// Which sweeps can be made of what a log holds.
class RawSweeps {
 public:
  void take(const LogEvent& event) {
    try {
      if (event.channel == channel::kLaserLine.name) lines_.insert(decode<laser_line_t>(event.bytes).utime);
      if (event.channel != channel::kSweepMark.name) return;
      const auto mark = decode<sweep_mark_t>(event.bytes);
      if (mark.mark == sweep_mark_t::STARTED) started_[{mark.numbered_since, mark.sweep}] = mark.utime;
      if (mark.mark == sweep_mark_t::ENDED) ended_[{mark.numbered_since, mark.sweep}] = mark.utime;
    } catch (const BadMessage&) {
      // The assembler gets it too, and counts it.
    }
  }
  AssembledSweeps assembled() const {
    AssembledSweeps sweeps;
    for (const auto& [number, ended] : ended_) {
      const auto started = started_.find(number);
      if (started == started_.end()) continue;
      const auto line = lines_.lower_bound(started->second);
      if (line != lines_.end() && *line <= ended) sweeps.emplace(assembled_key(number.second), ended);
    }
    return sweeps;
  }

 private:
  std::map<std::pair<std::int64_t, std::int64_t>, Utime> started_, ended_;
  std::set<Utime> lines_;
};

PathReport path_report(const std::optional<path_t>& path) {
  if (!path) return {};
  return {.status = path->status,
          .unknown = path->unknown,
          .map_up_to_date = path->map_up_to_date != 0,
          .length_m = path->length_m,
          .duration_s = path->pose_time_s.empty() ? 0.0 : path->pose_time_s.back(),
          .clearance_m = path->clearance_m,
          .clearance_at_m = {path->clearance_at_m[0], path->clearance_at_m[1]},
          .unknown_share = path->unknown_share,
          .cost = path->cost,
          .worst_cost = path->worst_cost,
          .expansions = path->expansions};
}

}  // namespace

LogStory story_of_log(const std::string& path) {
  LogReader log(path);
  LogStory story;
  ObjectAssembler params;
  std::set<std::string> known;
  RawSweeps raw;
  while (const auto event = log.next()) {
    raw.take(*event);
    try {
      if (event->channel == channel::kSweepInputs.name) note(decode<sweep_inputs_t>(event->bytes), story.orientations);
      if (event->channel == channel::kMapAnswer.name) story.answers.push_back(decode<map_answer_t>(event->bytes));
      if (event->channel != channel::kParams.name) continue;
      const auto object = params.add(decode<piece_t>(event->bytes));
      if (!object || !known.insert(object->key).second || (story.robot && object->key != kMapper)) continue;
      story.robot = parse_robot(robot_yaml_of(decode<params_t>(object->bytes)), path + " (PARAMS)");
    } catch (const BadMessage& bad) {
      if (event->channel != channel::kParams.name) continue;  // Of no use to anybody, and the sweeps are there.
      throw InputError(printable(path) + ": its configuration (PARAMS) cannot be read: " + bad.what() +
                       "; name a robot file with --robot");
    }
  }
  story.assembled = raw.assembled();
  return story;
}

void Replay::ScanTimer::begin(std::string_view name) {
  run_.begin(name);
  scan_.begin(name);
}

std::vector<std::pair<std::string, double>> Replay::ScanTimer::finish_scan() {
  std::vector<std::pair<std::string, double>> seconds = scan_.finish();
  scan_ = StageTimer();
  return seconds;
}

Replay::Replay(const Robot& robot, LogWriter& recording, LogStory story)
    : robot_(robot),
      bus_(recording),
      scan_timer_(run_timer_),
      assembled_(std::move(story.assembled)),
      mapper_(bus_, robot, &scan_timer_),
      assembler_(
          bus_, robot, [this](SweepOrigin origin) { mapper_.expect(std::move(origin)); }, false),
      planner_(bus_, robot, &run_timer_) {
  mapper_.use(std::move(story.orientations));
  mapper_.use(std::move(story.answers));
  bus_.subscribe(channel::kRegistration.name, [this](const BusMessage& message) { note_scan(message); });
  bus_.subscribe(channel::kReferencePose.name, [this](const BusMessage& message) { note_reference(message); });
}

void Replay::run(LogReader& log, const std::function<void(double)>& progress) {
  for (bool first = true; const auto event = log.next();) {
    if (std::exchange(first, false)) begin(event->utime);
    if (!is_input(event->channel) || is_left_aside(*event)) continue;
    bus_.feed(event->channel, event->bytes, event->utime);
    if (progress) progress(static_cast<double>(event->offset) / static_cast<double>(log.file_bytes()));
  }
  assembler_.finish();
  bus_.dispatch();
  mapper_.finish();
  bus_.dispatch();
  planner_.finish();
  bus_.dispatch();
}

bool Replay::is_left_aside(const LogEvent& event) const {
  if (event.channel != channel::kSweep.name || assembled_.empty()) return false;
  try {
    const auto piece = decode<piece_t>(event.bytes);
    return assembled_.contains({piece.key, piece.version});
  } catch (const BadMessage&) {
    return false;  // The mapper counts it.
  }
}

void Replay::begin(Utime utime) {
  bus_.begin(utime);
  publish_object(bus_, channel::kParams, encode(params_message(utime, robot_text(robot_))), kParamsKey, 1, utime);
  if (continued_) mapper_.resume(*continued_);
  if (gone_on_with_ != nullptr) mapper_.restore(*gone_on_with_);
  bus_.dispatch();
}

void Replay::note_scan(const BusMessage& bytes) {
  const auto verdict = decode<registration_t>(bytes.bytes);
  ScanReport scan;
  scan.name = verdict.scan_name;
  scan.utime = verdict.utime;
  scan.target = verdict.target_name;
  scan.accepted = verdict.accepted != 0;
  scan.probability = verdict.probability;
  scan.overlap = verdict.overlap;
  scan.inlier_rmse_m = verdict.inlier_rmse_m;
  scan.reason = verdict.reason;
  scan.T_map_scan = get_rows(verdict.T_map_scan);
  scan.seconds = scan_timer_.finish_scan();
  scans_.push_back(std::move(scan));
}

void Replay::note_reference(const BusMessage& bytes) {
  try {
    const auto reference = decode<reference_pose_t>(bytes.bytes);
    const Pose T_ref_scan = get_rows(reference.T_ref_scan);
    if (reference.scan_name == kSimulator) truth_[reference.utime] = T_ref_scan;
    if (reference.scan_name != kSimulator) references_[reference.scan_name] = T_ref_scan;
  } catch (const BadMessage&) {
    // A reference serves comparison only; without it the scan is reported without an error.
  }
}

std::map<std::string, std::int64_t> Replay::counters() const {
  std::map<std::string, std::int64_t> counters = mapper_.counters();
  counters.merge(assembler_.counters());
  counters.merge(planner_.counters());
  return counters;
}

/// Its own, or where the simulated robot stood when its last point was measured.
std::optional<Pose> Replay::reference_of(const ScanReport& scan) const {
  const auto reference = references_.find(scan.name);
  if (reference != references_.end()) return reference->second;
  const auto later = truth_.upper_bound(scan.utime);
  return later == truth_.begin() ? std::nullopt : std::optional(std::prev(later)->second);
}

/// Later sweeps may have moved earlier ones. Those of a map that was continued come before the log's.
void Replay::note_last_poses(std::vector<ScanReport>& scans) const {
  auto held = mapper_.mapper().trajectory().rbegin();
  for (auto scan = scans.rbegin(); scan != scans.rend(); ++scan) {
    if (scan->accepted) scan->T_map_scan = (held++)->X_map_sweep;
  }
}

ReplayReport Replay::report() {
  ReplayReport report;
  report.scans = scans_;
  for (ScanReport& scan : report.scans) scan.T_ref_scan = reference_of(scan);
  note_last_poses(report.scans);
  report.counters = counters();
  report.path_without_embodiment = path_report(planner_.without_embodiment());
  report.path_with_embodiment = path_report(planner_.with_embodiment());
  report.seconds = run_timer_.finish();
  return report;
}

}  // namespace scanway
