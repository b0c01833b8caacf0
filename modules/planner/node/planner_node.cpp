#include "modules/planner/node/planner_node.h"

#include <algorithm>
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

std::string name_of(planning::BodyMode mode) {
  switch (mode) {
    case planning::BodyMode::point: return "point";
    case planning::BodyMode::paper: return "paper";
    default: return "footprint";
  }
}

void put_result(const planning::PlanResult& result, path_t& message) {
  message.status = result.reason;
  for (const planning::PathPose& pose : result.path) {
    message.pose_x_m.push_back(pose.x_m);
    message.pose_y_m.push_back(pose.y_m);
    message.pose_heading_rad.push_back(pose.heading);
  }
  message.nposes = static_cast<std::int32_t>(result.path.size());
  message.length_m = result.length_m;
  message.clearance_m = result.clearance_m;
  message.clearance_at_m[0] = result.clearance_at_m.x();
  message.clearance_at_m[1] = result.clearance_at_m.y();
  message.unknown_share = result.unknown_share;
  message.cost = result.cost;
  message.expansions = static_cast<std::int64_t>(result.effort.expansions);
}

}  // namespace

PlannerNode::PlannerNode(Bus& bus, const Robot& robot, StageListener* stages)
    : bus_(bus),
      stages_(stages),
      point_{name_of(planning::BodyMode::point), planning::Planner(robot, planning::BodyMode::point), {}},
      body_{name_of(mode_of(robot)), planning::Planner(robot, mode_of(robot)), {}},
      inputs_(merged_channels(), [this](std::size_t, Utime, Input&& input) { work_on(std::move(input)); }) {
  bus_.subscribe(channel::kPose.name, [this](const BusMessage& message) { take_pose(message); });
  bus_.subscribe(channel::kCostMapTile.name, [this](const BusMessage& message) { take_tile(message); });
  bus_.subscribe(channel::kCostMapIndex.name, [this](const BusMessage& message) { take_index(message); });
  bus_.subscribe(channel::kGoal.name, [this](const BusMessage& message) { take_goal(message); });
}

std::map<std::string, std::int64_t> PlannerNode::counters() const {
  return {{"planner_bad_messages", bad_messages_},
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
    inputs_.add(kPoseInput, pose.utime, Start{pose.utime, pose_of(pose)});
  } catch (const BadMessage&) {
    ++bad_messages_;
  }
}

void PlannerNode::take_tile(const BusMessage& message) {
  try {
    const std::optional<Object> object = tiles_.add(decode<piece_t>(message.bytes));
    if (object) take_version(replica_.add_tile(decode<cost_tile_t>(object->bytes), object->digest));
  } catch (const BadMessage&) {
    ++bad_messages_;
  }
}

void PlannerNode::take_index(const BusMessage& message) {
  try {
    const std::optional<Object> object = indices_.add(decode<piece_t>(message.bytes));
    if (object) take_version(replica_.add_index(decode<cost_map_index_t>(object->bytes)));
  } catch (const BadMessage&) {
    ++bad_messages_;
  }
}

void PlannerNode::take_goal(const BusMessage& message) {
  try {
    const auto goal = decode<goal_t>(message.bytes);
    inputs_.add(kGoalInput, goal.utime, Goal{goal.utime, goal_of(goal)});
  } catch (const BadMessage&) {
    ++bad_messages_;
  }
}

void PlannerNode::take_version(std::optional<ClosedVersion> version) {
  if (!version) return;
  const Utime utime = version->utime;
  inputs_.add(kMapInput, utime, std::move(*version));
}

void PlannerNode::work_on(Input&& input) {
  if (const auto* start = std::get_if<Start>(&input)) {
    start_ = *start;
    return;  // A pose comes with its version of the map, which is next.
  }
  if (auto* version = std::get_if<ClosedVersion>(&input)) {
    change_map(*version);
    version->changes.clear();
    version_ = std::move(*version);
  } else {
    goal_ = std::get<Goal>(input);
  }
  plan();
}

void PlannerNode::change_map(const ClosedVersion& version) {
  begin_stage(stages_, "planner_map");
  apply(version, map_);
  std::vector<Cell> tiles;
  for (const auto& [tile, cells] : version.changes) tiles.push_back(tile);
  for (Mode* mode : {&point_, &body_}) {
    if (version_) {
      mode->planner.update(map_, tiles);
    } else {
      mode->planner.set_map(map_);
    }
  }
  begin_stage(stages_, "");
}

void PlannerNode::plan() {
  if (!version_ || !start_ || !goal_) return;
  begin_stage(stages_, "plan");
  plan(point_);
  plan(body_);
  begin_stage(stages_, "");
}

void PlannerNode::plan(Mode& mode) {
  path_t message = about(mode);
  put_result(mode.planner.plan(start_->X_map_base.translation().head<2>(), goal_->place), message);
  publish_object(bus_, channel::kPath, encode(message), mode.name, message.utime, message.utime);
  mode.newest = std::move(message);
}

path_t PlannerNode::about(const Mode& mode) const {
  path_t message{};
  message.utime = std::max({version_->utime, start_->utime, goal_->utime});
  message.map_version = version_->version;
  message.map_digest = version_->digest;
  message.map_up_to_date = true;
  message.mode = mode.name;
  message.start[0] = start_->X_map_base.translation().x();
  message.start[1] = start_->X_map_base.translation().y();
  message.start[2] = heading_of(start_->X_map_base.linear());
  message.goal[0] = goal_->place.x();
  message.goal[1] = goal_->place.y();
  return message;
}

}  // namespace scanway
