#pragma once

#include <vector>

#include "tests/bench/ground/aerial/sample.h"

namespace scanway::bench {

/// The mapper's ground, plane and surface, for a cloud that no robot took: as if one had stood every ten columns, each
/// with its own sweep of what is around. A point is ground if most of those who have ground there say so.
///
/// The mapper's lengths are those of a robot on the ground. Here all of space is shrunk until a column (0.1 m) holds
/// one point, so that its 0.3 m, 2 m and so on are 3 and 20 points apart. What is not a number of points has its own
/// measure, from what airborne filters use and not from these samples:
struct StandsConfig {
  double step_m = 0.5;    ///< CSF's distance from the ground, and about SMRF's elevation threshold.
  double slope = 0.7854;  ///< Radians: 45 degrees, PCL's tutorial of its filter.
  double reach_m = 30.0;  ///< To each side of a stand: more than a house. At least kLeastReach points.
  double sigma_m = 0.1;   ///< Of an airborne height.
};

std::vector<bool> stands_filter(const Sample& sample, const StandsConfig& config);

}  // namespace scanway::bench
