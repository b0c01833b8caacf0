#pragma once

#include "tests/bench/planning/scenes.h"

namespace scanway::bench {

/// CPU milliseconds of what a planner did that was kept alive, and of new ones for the same problems.
struct Life {
  double kept_ms = 0.0;
  double anew_ms = 0.0;  ///< Of those that were tried, times `every`.
  int plans = 0;
  int differ = 0;  ///< Plans whose cost was another than a new planner's.
};

/// The robot drives 4,000 cells from one corner towards the other. After every 20 a block of 5 x 5 cells appears on its
/// way, 15 to 25 cells ahead, and the one before vanishes. Every `every`-th problem is given to a new planner too.
Life drive(Scene scene, int every);
/// The robot stands in one corner; the goal leaves the other, 10 cells at a time, a hundred times.
Life follow(const Scene& scene, int every);
/// 200 x 200 cells around the goal change, 20 cells from it.
Life change_near_goal(Scene scene);

}  // namespace scanway::bench
