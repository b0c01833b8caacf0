#pragma once

#include <optional>

#include <Eigen/Core>

#include "common/geometry/pose.h"
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

/// A mode's name in PATH.
const char* name_of(planning::BodyMode mode);

/// A plan as a message. `basis` is complete.
path_t path_message(const PlanBasis& basis, planning::BodyMode mode, const planning::PlanResult& result);

}  // namespace scanway
