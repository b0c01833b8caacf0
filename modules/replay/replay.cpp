#include "modules/replay/replay.h"

#include <utility>

#include "common/bus/channels.h"
#include "common/config/robot_file.h"
#include "common/files/input_error.h"
#include "common/files/printable.h"
#include "common/messages/bad_message.h"
#include "common/messages/codec.h"
#include "common/messages/object_assembler.h"
#include "common/messages/params_message.h"
#include "common/messages/rigid.h"
#include "scanway/reference_pose_t.hpp"

namespace scanway {
namespace {

/// What a robot measures and people ask for. All else in a log is derived from it.
constexpr const Channel* kInputs[] = {&channel::kParams, &channel::kImu, &channel::kSweep, &channel::kReferencePose,
                                      &channel::kGoal};

bool is_input(std::string_view name) {
  for (const Channel* input : kInputs) {
    if (input->name == name) return true;
  }
  return false;
}

PathReport path_report(const std::optional<path_t>& path) {
  if (!path) return {};
  return {path->status, path->length_m, path->clearance_m, path->unknown_share, path->cost, path->expansions};
}

}  // namespace

std::optional<Robot> robot_of_log(const std::string& path) {
  LogReader log(path);
  ObjectAssembler params;
  while (const auto event = log.next()) {
    if (event->channel != channel::kParams.name) continue;
    try {
      const auto object = params.add(decode<piece_t>(event->bytes));
      if (object) return parse_robot(robot_yaml_of(decode<params_t>(object->bytes)), path + " (PARAMS)");
    } catch (const BadMessage& bad) {
      throw InputError(printable(path) + ": its configuration (PARAMS) cannot be read: " + bad.what() +
                       "; name a robot file with --robot");
    }
  }
  return std::nullopt;
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

Replay::Replay(const Robot& robot, LogWriter& recording)
    : bus_(recording), scan_timer_(run_timer_), mapper_(bus_, robot, &scan_timer_), planner_(bus_, robot, &run_timer_) {
  bus_.subscribe(channel::kRegistration.name, [this](const BusMessage& message) { note_scan(message); });
  bus_.subscribe(channel::kReferencePose.name, [this](const BusMessage& message) { note_reference(message); });
}

void Replay::run(LogReader& log, const std::function<void(double)>& progress) {
  while (const auto event = log.next()) {
    if (!is_input(event->channel)) continue;
    bus_.feed(event->channel, event->bytes, event->utime);
    if (progress) progress(static_cast<double>(event->offset) / static_cast<double>(log.file_bytes()));
  }
  mapper_.finish();
  bus_.dispatch();
  planner_.finish();
  bus_.dispatch();
}

void Replay::note_scan(const BusMessage& bytes) {
  const auto verdict = decode<registration_t>(bytes.bytes);
  ScanReport scan;
  scan.name = verdict.scan_name;
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
    references_[reference.scan_name] = get_rows(reference.T_ref_scan);
  } catch (const BadMessage&) {
    // A reference serves comparison only; without it the scan is reported without an error.
  }
}

std::map<std::string, std::int64_t> Replay::counters() const {
  std::map<std::string, std::int64_t> counters = mapper_.counters();
  counters.merge(planner_.counters());
  return counters;
}

ReplayReport Replay::report() {
  ReplayReport report;
  report.scans = scans_;
  for (ScanReport& scan : report.scans) {
    const auto reference = references_.find(scan.name);
    if (reference != references_.end()) scan.T_ref_scan = reference->second;
  }
  report.counters = counters();
  report.path_without_embodiment = path_report(planner_.without_embodiment());
  report.path_with_embodiment = path_report(planner_.with_embodiment());
  report.seconds = run_timer_.finish();
  return report;
}

}  // namespace scanway
