#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include <Eigen/Core>

#include "common/geometry/pose.h"
#include "common/grid/cost_map.h"
#include "common/progress/stages.h"
#include "common/robot/robot.h"
#include "common/time/utime.h"
#include "modules/planner/core/planner.h"
#include "modules/planner/node/cost_map_replica.h"
#include "scanway/path_t.hpp"

namespace scanway {

struct Goal {
  Utime utime = 0;
  Eigen::Vector2d place;
};

struct Start {
  Utime utime = 0;
  Pose X_map_base;
};

/// What a plan rests on, beside the cells of the map.
struct PlanBasis {
  std::optional<ClosedVersion> version;  ///< Without its tiles.
  std::optional<Start> start;
  std::optional<Goal> goal;

  bool complete() const { return version && start && goal; }
};

// Names in PATH.
const char* name_of(planning::BodyMode mode);
const char* name_of(UnknownPolicy policy);

/// A plan as a message. `basis` is complete.
path_t path_message(const PlanBasis& basis, planning::BodyMode mode, const planning::PlanResult& result);

/// The plan that counts for this basis, whatever was planned before. `map` is the basis' version, `stages` may be
/// absent.
path_t planned_path(const Robot& robot, planning::BodyMode mode, const CostMap& map, const PlanBasis& basis,
                    StageListener* stages = nullptr);

/// The versions of PATH's objects: the plan's time, and never the same twice for a mode, so that a newer plan always
/// replaces an older one.
class PathVersions {
 public:
  std::int64_t next(const path_t& path) {
    const auto newest = newest_.find(path.mode);
    const std::int64_t version = newest == newest_.end() ? path.utime : std::max(path.utime, newest->second + 1);
    newest_[path.mode] = version;
    return version;
  }

 private:
  std::map<std::string, std::int64_t> newest_;
};

}  // namespace scanway
