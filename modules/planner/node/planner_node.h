#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include "common/bus/bus.h"
#include "common/bus/ordered_merge.h"
#include "common/grid/cost_map.h"
#include "common/messages/object_input.h"
#include "common/progress/stages.h"
#include "common/robot/robot.h"
#include "modules/planner/core/planner.h"
#include "modules/planner/node/cost_map_replica.h"
#include "modules/planner/node/plan_basis.h"
#include "modules/planner/node/provisional_planner.h"
#include "scanway/map_state_t.hpp"
#include "scanway/path_t.hpp"

namespace scanway {

/// The planner on the bus: POSE, COST_MAP_TILE with COST_MAP_INDEX, and GOAL in, merged by their own time; for each
/// closed version, start and goal one PATH a mode out: for a point, and for the robot's body. Such a PATH depends on
/// these three alone, not on what was planned before. A live planner plans at once as well (provisional_planner.h).
class PlannerNode {
 public:
  enum class Pace { data_time, live };

  /// `bus` and `stages` must outlive this.
  PlannerNode(Bus& bus, const Robot& robot, StageListener* stages = nullptr, Pace pace = Pace::data_time);

  /// No more input will come: what still waits for data with a later time is worked on now.
  void finish() { inputs_.flush(); }

  /// `finished` is told of each time that it planned, by the version of the map and the newest input's time.
  void on_finished(std::function<void(std::string_view, Utime)> finished) { finished_ = std::move(finished); }

  /// Nothing has come for a while. If the mapper has said since the last call that it is settled at the version that is
  /// here, nothing with an earlier time will come, and what waits is worked on.
  void settle();
  void take_goal(const BusMessage& message);  ///< As from the bus.
  std::size_t news() const { return news_; }  ///< Inputs taken so far.
  std::string summary() const;                ///< What people should know, in one line; empty: nothing.
  /// Whether the mapper has begun another map, so that what is here is of no use any more.
  bool outdated() const { return outdated_; }

  const CostMap& map() const { return map_; }
  /// The newest plan of a mode; nothing before the first.
  const std::optional<path_t>& without_embodiment() const { return without_embodiment_; }
  const std::optional<path_t>& with_embodiment() const { return with_embodiment_; }
  /// What was bad, late or incomplete so far, by name.
  std::map<std::string, std::int64_t> counters() const;

 private:
  using Input = std::variant<Start, ClosedVersion, Goal>;

  void take_pose(const BusMessage& message);
  void take_tile(const BusMessage& message);
  void take_index(const BusMessage& message);
  void take_state(const BusMessage& message);
  void take_version(std::optional<ClosedVersion> version);
  void take(std::size_t channel, Utime utime, Input input);
  void add(std::size_t channel, Utime utime, Input input);
  void guarded(const std::function<void()>& work);
  void work_on(Input&& input);
  void change_map(const ClosedVersion& version);
  void plan();
  void plan_provisionally();
  void finish_work(const std::string& what);
  path_t plan(planning::BodyMode mode);

  Bus& bus_;
  StageListener* stages_;
  Robot robot_;
  planning::BodyMode body_;
  CostMap map_;
  PlanBasis basis_;
  ObjectInput<cost_tile_t> tiles_;
  ObjectInput<cost_map_index_t> indices_;
  CostMapReplica replica_;
  OrderedMerge<Input> inputs_;
  std::optional<ProvisionalPlanner> provisional_;
  PathVersions newest_;
  std::optional<path_t> without_embodiment_;
  std::optional<path_t> with_embodiment_;
  std::optional<Utime> newest_pose_;
  std::optional<Goal> newest_goal_;
  std::optional<map_state_t> mapper_;  // What it said since the last settle().
  std::function<void(std::string_view, Utime)> finished_;
  bool outdated_ = false;
  std::size_t news_ = 0;
  std::int64_t bad_messages_ = 0;
  std::string trouble_;  // Why nothing can be planned on this map, ever; empty: it can.
};

}  // namespace scanway
