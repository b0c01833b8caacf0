#include "modules/planner/node/planner_node.h"

#include <algorithm>
#include <stdexcept>
#include <utility>
#include <vector>

#include "common/bus/channels.h"
#include "common/messages/bad_message.h"
#include "common/messages/codec.h"
#include "common/messages/cost_map_message.h"
#include "common/messages/goal_message.h"
#include "common/messages/objects.h"
#include "common/messages/pose_message.h"

namespace scanway {
namespace {

enum InputChannel : std::size_t { kPoseInput, kMapInput, kGoalInput };

/// A map's tiles may still be on their way this long after the sweep that they come from.
constexpr Utime kMapBound = 200 * kMicrosecondsPerSecond;

std::vector<MergedChannel> merged_channels() {
  return {{std::string(channel::kPose.name), kMapBound, true},
          {std::string(channel::kCostMapIndex.name), kMapBound, true},
          {std::string(channel::kGoal.name), kMicrosecondsPerSecond, true}};
}

planning::BodyMode mode_of(const Robot& robot) {
  return robot.mapping.embodiment == Embodiment::paper ? planning::BodyMode::paper : planning::BodyMode::footprint;
}

}  // namespace

PlannerNode::PlannerNode(Bus& bus, const Robot& robot, StageListener* stages, Pace pace)
    : bus_(bus),
      stages_(stages),
      robot_(robot),
      body_(mode_of(robot)),
      inputs_(merged_channels(), [this](std::size_t, Utime, Input&& input) { work_on(std::move(input)); }) {
  if (pace == Pace::live) provisional_.emplace(bus, robot, std::vector{planning::BodyMode::point, body_});
  bus_.subscribe(channel::kPose.name, [this](const BusMessage& message) { take_pose(message); });
  bus_.subscribe(channel::kCostMapTile.name, [this](const BusMessage& message) { take_tile(message); });
  bus_.subscribe(channel::kCostMapIndex.name, [this](const BusMessage& message) { take_index(message); });
  bus_.subscribe(channel::kGoal.name, [this](const BusMessage& message) { take_goal(message); });
  bus_.subscribe(channel::kMapState.name, [this](const BusMessage& message) { take_state(message); });
}

std::map<std::string, std::int64_t> PlannerNode::counters() const {
  return {
      {"planner_bad_messages", bad_messages_ + tiles_.bad_messages() + indices_.bad_messages()},
      {"planner_bad_pieces", static_cast<std::int64_t>(tiles_.counters().bad_pieces + indices_.counters().bad_pieces)},
      {"planner_bad_objects",
       static_cast<std::int64_t>(tiles_.counters().bad_objects + indices_.counters().bad_objects)},
      {"planner_late_maps", static_cast<std::int64_t>(inputs_.late(kMapInput))},
      {"planner_late_poses", static_cast<std::int64_t>(inputs_.late(kPoseInput))},
      {"planner_late_goals", static_cast<std::int64_t>(inputs_.late(kGoalInput))},
      {"planner_map_behind", replica_.up_to_date() ? 0 : 1}};
}

void PlannerNode::take_pose(const BusMessage& message) {
  try {
    const auto pose = decode<bot_core::pose_t>(message.bytes);
    if (newest_pose_ == pose.utime) return;  // The mapper says its newest pose again and again.
    newest_pose_ = pose.utime;
    take(kPoseInput, pose.utime, Start{pose.utime, pose_of(pose)});
  } catch (const BadMessage&) {
    ++bad_messages_;
  }
}

void PlannerNode::take_tile(const BusMessage& message) {
  tiles_.take(message.bytes, [this](const cost_tile_t& tile, const Object& object) {
    take_version(replica_.add_tile(tile, object.digest));
  });
}

void PlannerNode::take_index(const BusMessage& message) {
  indices_.take(message.bytes,
                [this](const cost_map_index_t& index, const Object&) { take_version(replica_.add_index(index)); });
}

void PlannerNode::take_goal(const BusMessage& message) {
  try {
    const auto goal = decode<goal_t>(message.bytes);
    const Goal wanted{goal.utime, goal_of(goal)};
    if (newest_goal_ && newest_goal_->utime == wanted.utime && newest_goal_->place == wanted.place)
      return;  // Repeated.
    newest_goal_ = wanted;
    take(kGoalInput, wanted.utime, wanted);
  } catch (const BadMessage&) {
    ++bad_messages_;
  }
}

void PlannerNode::take_state(const BusMessage& message) {
  try {
    mapper_ = decode<map_state_t>(message.bytes);
    outdated_ = outdated_ || mapper_->map_version < replica_.closed_version();
  } catch (const BadMessage&) {
    ++bad_messages_;
  }
}

void PlannerNode::take_version(std::optional<ClosedVersion> version) {
  if (!version) return;
  const Utime utime = version->utime;
  take(kMapInput, utime, std::move(*version));
}

void PlannerNode::take(std::size_t channel, Utime utime, Input input) {
  ++news_;
  guarded([&] { add(channel, utime, std::move(input)); });
}

// A live planner that cannot plan on a map says so and goes on: the mapper may begin another. Replay ends with the
// line.
void PlannerNode::guarded(const std::function<void()>& work) {
  if (!trouble_.empty()) return;
  try {
    work();
  } catch (const std::length_error& too_large) {
    if (!provisional_) throw;
    trouble_ = std::string(too_large.what()) + "; no more paths until the mapper begins another map";
  }
}

void PlannerNode::add(std::size_t channel, Utime utime, Input input) {
  if (provisional_) std::visit([this](const auto& value) { provisional_->take(value); }, input);
  // Late is counted, but what is newest is the state of the world all the same: a goal is still the operator's will,
  // and the next version of the map builds on this one.
  if (!inputs_.add(channel, utime, input)) work_on(std::move(input));
  if (provisional_ && inputs_.waiting() > 0) plan_provisionally();
}

void PlannerNode::plan_provisionally() {
  const std::int64_t before = provisional_->plans();
  begin_stage(stages_, "provisional_plan");
  provisional_->plan(replica_.up_to_date());
  begin_stage(stages_, "");
  if (provisional_->plans() != before) finish_work("provisional plan");
}

void PlannerNode::finish_work(const std::string& what) {
  if (!finished_) return;
  const Utime map = basis_.version ? basis_.version->utime : 0;
  finished_(what, std::max({map, newest_pose_.value_or(0), newest_goal_ ? newest_goal_->utime : 0}));
}

void PlannerNode::settle() {
  const std::optional<map_state_t> mapper = std::exchange(mapper_, std::nullopt);
  if (mapper && mapper->settled && mapper->map_version == replica_.closed_version() && replica_.up_to_date()) {
    guarded([this] { inputs_.flush(); });
  }
}

std::string PlannerNode::summary() const {
  if (!trouble_.empty()) return trouble_;
  if (!replica_.up_to_date()) return "the map is behind the mapper's: its tiles are still coming";
  if (!basis_.goal && !provisional_) return {};
  if (inputs_.waiting() > 0) return "a plan waits for later data; the provisional one is out";
  return {};
}

void PlannerNode::work_on(Input&& input) {
  if (const auto* start = std::get_if<Start>(&input)) {
    if (basis_.start && start->utime < basis_.start->utime) return;
    basis_.start = *start;
    return;  // A pose comes with its version of the map, which is next.
  }
  if (auto* version = std::get_if<ClosedVersion>(&input)) {
    change_map(*version);
    version->changes.clear();
    basis_.version = std::move(*version);
  } else {
    const Goal& goal = std::get<Goal>(input);
    if (basis_.goal && goal.utime < basis_.goal->utime) return;
    basis_.goal = goal;
  }
  plan();
}

void PlannerNode::change_map(const ClosedVersion& version) {
  begin_stage(stages_, "planner_map");
  apply(version, map_);
  begin_stage(stages_, "");
}

void PlannerNode::plan() {
  if (!basis_.complete()) return;
  without_embodiment_ = plan(planning::BodyMode::point);
  with_embodiment_ = plan(body_);
  begin_stage(stages_, "");
  finish_work("map version " + std::to_string(basis_.version->version));
}

path_t PlannerNode::plan(planning::BodyMode mode) {
  path_t message = planned_path(robot_, mode, map_, basis_, stages_);
  publish_object(bus_, channel::kPath, encode(message), message.mode, newest_.next(message), message.utime);
  return message;
}

}  // namespace scanway
