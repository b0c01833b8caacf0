#pragma once

namespace scanway::planning {

enum class PlanStatus {
  ok,
  no_map,         ///< There is no known cell yet.
  start_off_map,  ///< Also for a start that is no finite number; so is the goal.
  goal_off_map,
  start_in_obstacle,
  goal_in_obstacle,
  start_unknown,  ///< Under `never`.
  goal_unknown,
  start_too_tight,  ///< The start is free, but the body does not fit there at any heading.
  goal_too_tight,
  walled_in,             ///< Obstacles part the start from the goal.
  only_through_unknown,  ///< Every way leads through unknown cells, and the policy is `never`.
  too_narrow,            ///< There is a way, but not for this body.
};

const char* words_of(PlanStatus status);

}  // namespace scanway::planning
