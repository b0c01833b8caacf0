#include "modules/replay/verify/verify.h"

#include <algorithm>
#include <memory>

#include <fmt/format.h>

#include "common/bus/memory_bus.h"
#include "common/files/input_error.h"
#include "common/files/printable.h"
#include "common/messages/codec.h"
#include "common/messages/pose_message.h"
#include "modules/mapper/node/mapper_node.h"
#include "modules/mapper/node/sweep_assembler.h"
#include "modules/mapper/node/sweep_store.h"
#include "modules/replay/verify/configuration.h"
#include "modules/replay/verify/derived_products.h"
#include "modules/replay/verify/played.h"
#include "modules/replay/verify/recorded_log.h"
#include "modules/replay/verify/recorded_paths.h"
#include "modules/replay/verify/sweep_list.h"
#include "scanway/map_answer_t.hpp"
#include "scanway/registration_t.hpp"

namespace scanway {
namespace {

/// What became of commands to the map.
std::vector<map_answer_t> answers_of(const RecordedLog& log) {
  std::vector<map_answer_t> answers;
  for (const auto& [utime, bytes] : log.messages(channel::kMapAnswer.name)) {
    answers.push_back(decode<map_answer_t>(bytes));
  }
  return answers;
}

/// A mapper that works on listed sweeps, one after the other; those that were assembled are assembled again.
class Rerun {
 public:
  /// `poses` gets where the robot stood.
  Rerun(const Robot& robot, const RecordedLog& log, std::vector<Start>& poses)
      : mapper_(bus_, robot),
        assembler_(
            bus_, robot, [this](SweepOrigin origin) { mapper_.expect(std::move(origin)); }, false),
        answers_(answers_of(log)) {
    derived_.listen(bus_);
    bus_.subscribe(channel::kSweepInputs.name, [this](const BusMessage& message) {
      last_sweep_ = decode<sweep_inputs_t>(message.bytes).sweep_digest;
    });
    bus_.subscribe(channel::kPose.name, [&poses](const BusMessage& message) {
      const auto pose = decode<bot_core::pose_t>(message.bytes);
      poses.push_back({pose.utime, pose_of(pose)});
    });
  }

  void resume(const SweepStore& map) {
    mapper_.resume(map);
    bus_.dispatch();
  }
  void add(const ListedSweep& sweep) {
    derived_.clear();
    for (const auto& [channel, message] : sweep.messages) bus_.publish(channel, message, sweep.utime);
    bus_.dispatch();
    assembler_.finish();
    if (!sweep.is_assembled()) {
      for (const auto& [number, piece] : sweep.sweep->pieces()) bus_.publish(channel::kSweep.name, piece, sweep.utime);
    }
    bus_.dispatch();
    mapper_.finish();
    bus_.dispatch();
  }
  /// Carries out the next command that followed this sweep. False: none did.
  bool carry_out_next() {
    const auto next = std::ranges::find_if(answers_, [this](const map_answer_t& answer) {
      return answer.done != 0 && answer.answered.command == map_command_t::WITHDRAW &&
             answer.after_sweep_digest == last_sweep_;
    });
    if (next == answers_.end()) return false;
    bus_.publish(channel::kMapCommand.name, encode(next->answered), next->answered.utime);
    answers_.erase(next);
    bus_.dispatch();
    return true;
  }
  const DerivedProducts& derived() const { return derived_; }
  const CostMap& cost_map() const { return mapper_.mapper().map().cost_map(); }
  /// Without its tiles.
  ClosedVersion version() const {
    const map_state_t state = mapper_.state();
    return {state.map_version, state.utime, state.map_digest, 0, 0, 0, {}};
  }

 private:
  MemoryBus bus_;
  MapperNode mapper_;
  SweepAssembler assembler_;
  DerivedProducts derived_;
  std::vector<map_answer_t> answers_;  // Of commands that are still to be carried out.
  std::int64_t last_sweep_ = 0;        // Digest of the one that was worked on last.
};

/// The whole work, a step a function.
class Verifier {
 public:
  Verifier(const std::string& path, const std::optional<Robot>& robot, const std::string& played,
           const std::string& resumed)
      : log_(path), paths_(log_) {
    result_.holds_derived = log_.holds_derived();
    result_.trouble = log_.trouble();
    if (result_.holds_derived) configure(path, robot);
    if (configured_) begin(resumed);
    const bool continues = rerun_ && rerun_->version().version > 0;
    list_ = list_sweeps(log_, continues ? std::optional(rerun_->version().utime) : std::nullopt);
    result_.sweeps = list_.sweeps.size();
    result_.missing.insert(result_.missing.begin(), list_.missing.begin(), list_.missing.end());
    const auto add = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
    add(result_.missing, paths_.missing());
    add(result_.notes, list_.notes);
    add(result_.notes, paths_.notes());
    if (!played.empty()) result_.unused = not_used(RecordedLog(played), log_);
  }

  Verification run(const std::function<void(double)>& progress) {
    if (result_.difference.empty()) result_.difference = list_.difference;
    if (result_.holds_derived && configured_) compute(progress);
    result_.products += paths_.compared();
    if (result_.difference.empty()) result_.difference = log_.first_fault();
    if (result_.difference.empty() && !log_.bad_messages().empty()) result_.difference = log_.bad_messages().front();
    return std::move(result_);
  }

 private:
  void configure(const std::string& path, const std::optional<Robot>& robot) {
    if (robot) {
      mapper_robot_ = planner_robot_ = *robot;
    } else {
      const LogConfiguration said = configuration_of(log_, path);
      result_.missing.insert(result_.missing.end(), said.missing.begin(), said.missing.end());
      result_.notes = said.notes;
      if (!said.mapper || !said.planner) return;
      mapper_robot_ = *said.mapper;
      planner_robot_ = *said.planner;
    }
    configured_ = true;
  }

  /// With the map that the session went on with, if it did.
  void begin(const std::string& resumed) {
    rerun_ = std::make_unique<Rerun>(mapper_robot_, log_, poses_);
    if (resumed.empty()) return;
    rerun_->resume(saved_map(resumed));
    if (rerun_->version().version > 0) compare(rerun_->version());
  }

  void compute(const std::function<void(double)>& progress) {
    bool all = true;
    for (const ListedSweep& sweep : list_.sweeps) {
      if (!result_.difference.empty()) return;
      if (can_compute(sweep)) {
        compute(sweep);
      } else if (const auto verdict = recorded_verdict(sweep); !verdict || verdict->accepted) {
        all = false;  // All that follows rests on it. A refused sweep leaves the map as it was.
        break;
      }
      if (progress) progress(static_cast<double>(result_.computed) / static_cast<double>(list_.sweeps.size()));
    }
    all = all && list_.not_listed.empty() && result_.difference.empty();
    if (all) result_.difference = paths_.compare_starts(poses_);
  }

  bool can_compute(const ListedSweep& sweep) const {
    const auto before = [&](Utime other) { return other < sweep.utime; };
    return sweep.complete && std::ranges::none_of(list_.not_listed, before);
  }

  void compute(const ListedSweep& sweep) {
    const auto verdict = recorded_verdict(sweep);
    // A mapper that was started without its state begins another map.
    const bool begins = verdict && verdict->accepted && verdict->target_name.empty();
    if (begins && rerun_->version().version > 0) rerun_ = std::make_unique<Rerun>(mapper_robot_, log_, poses_);
    const std::int64_t before = rerun_->version().version;
    rerun_->add(sweep);
    ++result_.computed;
    std::string in_paths;
    if (rerun_->version().version > before) in_paths = difference_of_paths();
    while (rerun_->carry_out_next() && in_paths.empty()) in_paths = difference_of_paths();
    compare_products(sweep.utime);
    if (result_.difference.empty()) result_.difference = in_paths;
  }

  std::string difference_of_paths() { return paths_.compare(planner_robot_, rerun_->cost_map(), rerun_->version()); }

  void compare(const ClosedVersion& version) {
    compare_products(version.utime);
    if (result_.difference.empty()) result_.difference = difference_of_paths();
  }

  void compare_products(Utime utime) {
    result_.difference = rerun_->derived().difference(log_, utime);
    if (!result_.difference.empty()) return;
    for (const RecordedName& product : log_.products_at(utime)) note_equal(product);
  }

  void note_equal(const RecordedName& product) {
    ++result_.products;
    const auto object = log_.objects().find(product);
    if (object == log_.objects().end() || object->second.whole()) return;
    result_.notes.push_back(
        fmt::format("compared by its digest alone: {}: lacks {}", text_of(product), object->second.lacking()));
  }

  std::optional<registration_t> recorded_verdict(const ListedSweep& sweep) const {
    const auto same_time = log_.messages(channel::kRegistration.name).equal_range(sweep.utime);
    for (auto one = same_time.first; one != same_time.second; ++one) {
      const auto verdict = decode<registration_t>(one->second);
      if (verdict.scan_name == sweep.name) return verdict;
    }
    return std::nullopt;
  }

  const RecordedLog log_;
  SweepList list_;
  RecordedPaths paths_;
  bool configured_ = false;
  Robot mapper_robot_;
  Robot planner_robot_;
  std::vector<Start> poses_;
  std::unique_ptr<Rerun> rerun_;
  Verification result_;
};

}  // namespace

Verification::Status Verification::status() const {
  if (!difference.empty() || !trouble.empty()) return kDifferent;
  if (!holds_derived) return kNothingDerived;
  return missing.empty() && unused.empty() ? kEqual : kIncomplete;
}

std::string Verification::findings() const {
  std::string text;
  if (!trouble.empty()) text += "damaged: the log is " + trouble + "\n";
  if (!difference.empty()) text += "different: " + difference + "\n";
  for (const std::string& input : missing) text += "missing: " + input + "\n";
  for (const std::string& input : unused) text += "not used: " + input + "\n";
  if (!holds_derived) return text + "nothing to verify: the log holds no derived object\n";
  if (!difference.empty() || missing.empty()) return text;
  return text +
         fmt::format("incomplete: {} of {} sweeps could be computed, {} objects equal\n", computed, sweeps, products);
}

std::string Verification::remarks() const {
  std::string text;
  for (const std::string& note : notes) text += "note: " + note + "\n";
  if (!holds_derived || !difference.empty() || !missing.empty()) return text;
  return text + fmt::format("verified: {} objects of {} sweeps equal\n", products, sweeps);
}

Verification verify(const std::string& log, const std::optional<Robot>& robot,
                    const std::function<void(double)>& progress, const std::string& played,
                    const std::string& resumed) {
  try {
    return Verifier(log, robot, played, resumed).run(progress);
  } catch (const BadMessage& bad) {
    throw InputError(printable(log) + ": cannot be verified: " + bad.what());
  }
}

}  // namespace scanway
