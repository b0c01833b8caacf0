#include "modules/planner/core/explain/plan_status.h"

namespace scanway::planning {

const char* words_of(PlanStatus status) {
  switch (status) {
    case PlanStatus::ok:
      return "ok";
    case PlanStatus::no_map:
      return "no map";
    case PlanStatus::start_off_map:
      return "start off the map";
    case PlanStatus::goal_off_map:
      return "goal off the map";
    case PlanStatus::start_in_obstacle:
      return "start in an obstacle";
    case PlanStatus::goal_in_obstacle:
      return "goal in an obstacle";
    case PlanStatus::start_unknown:
      return "start unknown";
    case PlanStatus::goal_unknown:
      return "goal unknown";
    case PlanStatus::start_too_tight:
      return "start too tight for this body";
    case PlanStatus::goal_too_tight:
      return "goal too tight for this body";
    case PlanStatus::walled_in:
      return "walled in";
    case PlanStatus::only_through_unknown:
      return "only through unknown";
    case PlanStatus::too_narrow:
      return "too narrow for this body";
  }
  return "";
}

}  // namespace scanway::planning
