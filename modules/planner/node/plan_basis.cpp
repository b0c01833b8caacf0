#include "modules/planner/node/plan_basis.h"

#include <algorithm>

namespace scanway {

const char* name_of(planning::BodyMode mode) {
  switch (mode) {
    case planning::BodyMode::point:
      return "point";
    case planning::BodyMode::paper:
      return "paper";
    default:
      return "footprint";
  }
}

const char* name_of(UnknownPolicy policy) {
  switch (policy) {
    case UnknownPolicy::price:
      return "price";
    case UnknownPolicy::free:
      return "free";
    default:
      return "never";
  }
}

path_t path_message(const PlanBasis& basis, planning::BodyMode mode, const planning::PlanResult& result) {
  path_t message{};
  message.utime = std::max({basis.version->utime, basis.start->utime, basis.goal->utime});
  message.map_version = basis.version->version;
  message.map_digest = basis.version->digest;
  message.map_up_to_date = true;
  message.mode = name_of(mode);
  message.start[0] = basis.start->X_map_base.translation().x();
  message.start[1] = basis.start->X_map_base.translation().y();
  message.start[2] = heading_of(basis.start->X_map_base.linear());
  message.goal[0] = basis.goal->place.x();
  message.goal[1] = basis.goal->place.y();
  message.unknown = name_of(result.unknown);
  message.status = result.reason;
  for (const planning::PathPose& pose : result.path) {
    message.pose_x_m.push_back(pose.x_m);
    message.pose_y_m.push_back(pose.y_m);
    message.pose_heading_rad.push_back(pose.heading);
    message.pose_time_s.push_back(pose.time_s);
    message.pose_speed_m_s.push_back(pose.speed_m_s);
  }
  message.nposes = static_cast<std::int32_t>(result.path.size());
  message.length_m = result.length_m;
  message.clearance_m = result.clearance_m;
  message.clearance_at_m[0] = result.clearance_at_m.x();
  message.clearance_at_m[1] = result.clearance_at_m.y();
  message.unknown_share = result.unknown_share;
  message.cost = result.cost;
  message.worst_cost = result.worst_cost;
  message.expansions = static_cast<std::int64_t>(result.effort.expansions);
  return message;
}

// A planner of its own each time: among ways of the same cost, one that has planned before may take another.
path_t planned_path(const Robot& robot, planning::BodyMode mode, const CostMap& map, const PlanBasis& basis,
                    StageListener* stages) {
  begin_stage(stages, "planner_map");
  planning::Planner planner(robot, mode);
  planner.set_map(map);
  begin_stage(stages, "plan");
  return path_message(basis, mode, planner.plan(basis.start->X_map_base.translation().head<2>(), basis.goal->place));
}

}  // namespace scanway
