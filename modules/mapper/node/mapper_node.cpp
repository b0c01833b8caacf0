#include "modules/mapper/node/mapper_node.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <span>
#include <utility>

#include "common/bus/channels.h"
#include "common/files/input_error.h"
#include "common/messages/bad_message.h"
#include "common/messages/codec.h"
#include "common/messages/digest.h"
#include "common/messages/imu_message.h"
#include "common/messages/pose_message.h"
#include "common/messages/sweep_message.h"
#include "modules/mapper/node/bytes_on_disk.h"
#include "modules/mapper/node/placement_message.h"
#include "modules/mapper/node/sweeps_on_disk.h"

namespace scanway {
namespace {

enum InputChannel : std::size_t { kImuInput, kSweepInput };

/// A sweep's pieces may still be on their way this long after it ended: 3.4 million points, paced and asked for again.
constexpr Utime kSweepBound = 200 * kMicrosecondsPerSecond;

/// An assembled sweep is published in seconds; if its pieces never come, no more than this waits for them.
constexpr std::size_t kMostHeld = 100'000;
constexpr int kMostSilences = 10;

std::vector<MergedChannel> merged_channels() {
  return {{std::string(channel::kImu.name), kMicrosecondsPerSecond, true},
          {std::string(channel::kSweep.name), kSweepBound, true}};
}

}  // namespace

MapperNode::MapperNode(Bus& bus, const Robot& robot, StageListener* stages)
    : bus_(bus),
      stages_(stages),
      mapper_(robot, 1, {}, {std::make_unique<SweepsOnDisk>(), std::make_shared<BytesOnDisk>()}),
      publisher_(bus),
      inputs_(merge()) {
  bus_.subscribe(channel::kImu.name, [this](const BusMessage& message) { take_imu(message); });
  bus_.subscribe(channel::kSweep.name, [this](const BusMessage& message) { take_piece(message); });
  bus_.subscribe(channel::kMapCommand.name, [this](const BusMessage& message) { take_command(message); });
}

OrderedMerge<MapperNode::Input> MapperNode::merge() {
  return {merged_channels(), [this](std::size_t, Utime, Input&& input) { work_on(std::move(input)); }};
}

std::map<std::string, std::int64_t> MapperNode::counters() const {
  const AssemblerCounters& pieces = sweeps_.counters();
  std::map<std::string, std::int64_t> counters{
      {"mapper_bad_messages", bad_messages_ + sweeps_.bad_messages()},
      {"mapper_bad_pieces", static_cast<std::int64_t>(pieces.bad_pieces)},
      {"mapper_bad_sweeps", static_cast<std::int64_t>(pieces.bad_objects)},
      {"mapper_repeated_pieces", static_cast<std::int64_t>(pieces.repeated_pieces)},
      {"mapper_incomplete_sweeps", static_cast<std::int64_t>(sweeps_.incomplete().size())},
      {"mapper_given_up_sweeps", static_cast<std::int64_t>(pieces.given_up)},
      {"mapper_late_imu", static_cast<std::int64_t>(inputs_.late(kImuInput))},
      {"mapper_late_sweeps", static_cast<std::int64_t>(inputs_.late(kSweepInput))},
      {"mapper_sweeps_settled_in_silence", settled_in_silence_},
      {"mapper_sweeps_without_orientation", without_orientation_}};
  counters.merge(placements_.counters());
  return counters;
}

void MapperNode::take_imu(const BusMessage& message) {
  try {
    const auto imu = decode<bot_core::ins_t>(message.bytes);
    const Orientation arrived{imu.utime, orientation_of(imu), {message.bytes.begin(), message.bytes.end()}};
    ++news_;
    if (const std::uint64_t name = digest(message.bytes); is_listed(name))
      listed_arrived_.insert_or_assign(name, arrived);
    held_.push_back(arrived);
    if (awaited_.empty() || held_.size() > kMostHeld) release_held();
  } catch (const BadMessage&) {
    ++bad_messages_;
  }
}

void MapperNode::take_piece(const BusMessage& message) {
  ++news_;
  sweeps_.take(message.bytes, [this](Sweep&& sweep, Object& object) {
    const Utime utime = sweep.utime;
    object.utime = utime;
    if (store_ == nullptr) object.bytes = {};
    ++waiting_sweeps_;
    awaited_.erase(object.digest);
    arrived_.insert(object.digest);
    if (!inputs_.add(kSweepInput, utime, ArrivedSweep{std::move(sweep), std::move(object)})) --waiting_sweeps_;
    if (awaited_.empty()) release_held();
  });
}

void MapperNode::work_on(Input&& input) {
  if (const auto* orientation = std::get_if<Orientation>(&input)) {
    newest_orientation_ = *orientation;
  } else {
    --waiting_sweeps_;
    add_sweep(std::get<ArrivedSweep>(std::move(input)));
  }
}

bool MapperNode::is_listed(std::uint64_t imu) const {
  return std::any_of(listed_.begin(), listed_.end(), [imu](const auto& sweep) { return sweep.second == imu; });
}

void MapperNode::expect(SweepOrigin origin) {
  const auto name = static_cast<std::uint64_t>(origin.inputs.sweep_digest);
  origins_.insert_or_assign(name, std::move(origin));
  if (!arrived_.contains(name)) awaited_.insert(name);
}

void MapperNode::release_held() {
  awaited_.clear();
  silences_ = 0;
  for (Orientation& orientation : std::exchange(held_, {})) {
    const Utime utime = orientation.utime;
    inputs_.add(kImuInput, utime, std::move(orientation));
  }
}

std::optional<MapperNode::Orientation> MapperNode::orientation_for(const ArrivedSweep& arrived) const {
  if (const auto origin = origins_.find(arrived.object.digest); origin != origins_.end()) {
    const auto& R_world_sweep = origin->second.R_world_sweep;
    if (!R_world_sweep) return std::nullopt;
    // As it is kept for a mapper that is started again.
    const auto imu = imu_message(arrived.sweep.utime, *R_world_sweep);
    return Orientation{arrived.sweep.utime, orientation_of(imu), encode(imu)};
  }
  if (const auto listed = listed_.find(arrived.object.digest); listed != listed_.end()) {
    const auto known = listed->second ? listed_arrived_.find(*listed->second) : listed_arrived_.end();
    return known == listed_arrived_.end() ? std::nullopt : std::optional(known->second);
  }
  const bool is_old = newest_orientation_ && arrived.sweep.utime - newest_orientation_->utime > kMaxOrientationAge;
  return is_old ? std::nullopt : newest_orientation_;
}

void MapperNode::add_sweep(ArrivedSweep&& arrived) {
  orientation_ = orientation_for(arrived);
  if (orientation_) arrived.sweep.R_world_sweep = orientation_->R_world_sweep;
  if (!orientation_) ++without_orientation_;
  if (!silent_) bus_.publish(channel::kSweepInputs.name, encode(inputs_of(arrived)), arrived.sweep.utime);
  keep(arrived.object, orientation_);
  const SweepResult result = mapper_.add(arrived.sweep, stages_);
  if (store_ != nullptr && result.verdict != Verdict::accepted) store_->drop(arrived.object);
  if (result.verdict == Verdict::accepted) map_utime_ = result.utime;
  last_sweep_ = arrived.object.digest;
  if (silent_) return;
  placements_.count(result);
  begin_stage(stages_, "publish");
  publish_result(result, arrived.sweep);
  carry_out_due();
  begin_stage(stages_, "");
  if (finished_) finished_(arrived.sweep.name, arrived.sweep.utime);
}

void MapperNode::finish() {
  release_held();
  inputs_.flush();
}

void MapperNode::settle(bool sweeps_expected) {
  if (!awaited_.empty() && (sweeps_expected || ++silences_ < kMostSilences)) return;
  release_held();
  if (!sweeps_expected) sweeps_.give_up_all();
  settled_in_silence_ += waiting_sweeps_;
  inputs_.flush();
}

map_state_t MapperNode::state() const {
  map_state_t state{};
  state.utime = map_utime_;
  state.map_version = static_cast<std::int64_t>(mapper_.map().version());
  state.map_digest = publisher_.cost_map_digest();
  state.settled = waiting_sweeps_ == 0 && awaited_.empty() && sweeps_.incomplete().empty();
  return state;
}

std::string MapperNode::summary() const {
  std::vector<std::string> sentences;
  if (!placements_.note().empty()) sentences.push_back(placements_.note());
  if (!store_trouble_.empty()) sentences.push_back(store_trouble_);
  if (const auto sweeps = sweeps_.incomplete(); !sweeps.empty()) {
    sentences.push_back(fmt::format("sweep {} lacks {} of {} pieces", sweeps.front().key, sweeps.front().missing_count,
                                    sweeps.front().npieces));
  }
  if (const std::uint64_t given_up = sweeps_.counters().given_up; given_up > 0) {
    sentences.push_back(fmt::format("{} sweeps never became whole and are not in the map", given_up));
  }
  if (waiting_sweeps_ > 0) sentences.push_back("a sweep waits for later data");
  if (without_orientation_ > 0) {
    sentences.push_back(fmt::format("{} sweeps had no orientation (IMU)", without_orientation_));
  }
  return fmt::format("{}", fmt::join(sentences, "; "));
}

sweep_inputs_t MapperNode::inputs_of(const ArrivedSweep& arrived) const {
  if (const auto origin = origins_.find(arrived.object.digest); origin != origins_.end()) return origin->second.inputs;
  sweep_inputs_t message{};
  message.utime = arrived.sweep.utime;
  message.sweep_name = arrived.sweep.name;
  message.sweep_digest = static_cast<std::int64_t>(arrived.object.digest);
  message.inputs = {imu_span()};
  message.ninputs = 1;
  return message;
}

input_span_t MapperNode::imu_span() const {
  input_span_t imu{};
  imu.channel = channel::kImu.name;
  imu.late_count = static_cast<std::int64_t>(inputs_.late(kImuInput));
  if (!orientation_) return imu;
  imu.first_utime = imu.last_utime = orientation_->utime;
  imu.used_count = 1;
  imu.used_digest = static_cast<std::int64_t>(digest(orientation_->message));
  return imu;
}

void MapperNode::publish_result(const SweepResult& result, const Sweep& sweep) {
  bus_.publish(channel::kRegistration.name, encode(registration_message(result)), result.utime);
  if (result.verdict != Verdict::accepted) return;
  bus_.publish(channel::kPose.name, encode(pose_message(result.utime, base_pose(result, sweep))), result.utime);
  publisher_.publish(mapper_.map(), result.change, result.utime);
}

}  // namespace scanway
