#pragma once

#include <cstdint>
#include <vector>

#include "common/bus/bus.h"
#include "common/grid/cost_map.h"
#include "common/robot/robot.h"
#include "modules/planner/core/planner.h"
#include "modules/planner/node/plan_basis.h"

namespace scanway {

/// Plans at once on the newest of everything, whatever may still come with an earlier time: for the operator, who
/// waits. Its plans are marked provisional, have keys of their own on PATH, and nothing that is compared rests on them.
class ProvisionalPlanner {
 public:
  /// `bus` must outlive this.
  ProvisionalPlanner(Bus& bus, const Robot& robot, const std::vector<planning::BodyMode>& modes);

  void take(const Start& start);
  void take(const Goal& goal);
  void take(const ClosedVersion& version);

  /// Publishes a plan a mode if there is something new to plan on. `map_up_to_date`: no newer version is on its way.
  void plan(bool map_up_to_date);
  std::int64_t plans() const { return plans_; }

 private:
  struct Mode {
    planning::BodyMode mode;
    planning::Planner planner;
  };

  Bus& bus_;
  std::vector<Mode> modes_;
  CostMap map_;
  PlanBasis basis_;
  PathVersions newest_;
  bool is_new_ = false;
  std::int64_t plans_ = 0;
};

}  // namespace scanway
