#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <variant>

#include <Eigen/Core>

#include "common/bus/bus.h"
#include "common/bus/ordered_merge.h"
#include "common/geometry/pose.h"
#include "common/grid/cost_map.h"
#include "common/messages/object_assembler.h"
#include "common/progress/stages.h"
#include "common/robot/robot.h"
#include "modules/planner/core/planner.h"
#include "modules/planner/node/cost_map_replica.h"
#include "scanway/path_t.hpp"

namespace scanway {

/// The planner on the bus: POSE, COST_MAP_TILE with COST_MAP_INDEX, and GOAL in, merged by their own time; for each
/// closed version, start and goal one PATH a mode out: for a point, and for the robot's body.
class PlannerNode {
 public:
  /// `bus` and `stages` must outlive this.
  PlannerNode(Bus& bus, const Robot& robot, StageListener* stages = nullptr);

  /// No more input will come: what still waits for data with a later time is worked on now.
  void finish() { inputs_.flush(); }

  const CostMap& map() const { return map_; }
  /// The newest plan of a mode; nothing before the first.
  const std::optional<path_t>& without_embodiment() const { return point_.newest; }
  const std::optional<path_t>& with_embodiment() const { return body_.newest; }
  /// What was bad, late or incomplete so far, by name.
  std::map<std::string, std::int64_t> counters() const;

 private:
  struct Goal {
    Utime utime = 0;
    Eigen::Vector2d place;
  };
  struct Start {
    Utime utime = 0;
    Pose X_map_base;
  };
  using Input = std::variant<Start, ClosedVersion, Goal>;
  struct Mode {
    std::string name;
    planning::Planner planner;
    std::optional<path_t> newest;
  };

  void take_pose(const BusMessage& message);
  void take_tile(const BusMessage& message);
  void take_index(const BusMessage& message);
  void take_goal(const BusMessage& message);
  void take_version(std::optional<ClosedVersion> version);
  void work_on(Input&& input);
  void change_map(const ClosedVersion& version);
  void plan();
  void plan(Mode& mode);
  path_t about(const Mode& mode) const;

  Bus& bus_;
  StageListener* stages_;
  CostMap map_;
  Mode point_;
  Mode body_;
  ObjectAssembler tiles_;
  ObjectAssembler indices_;
  CostMapReplica replica_;
  OrderedMerge<Input> inputs_;
  std::optional<ClosedVersion> version_;  // Without its tiles.
  std::optional<Start> start_;
  std::optional<Goal> goal_;
  std::int64_t bad_messages_ = 0;
};

}  // namespace scanway
