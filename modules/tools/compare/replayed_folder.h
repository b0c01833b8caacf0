#pragma once

#include <string>
#include <vector>

#include "common/cloud/sweep.h"
#include "common/geometry/pose.h"
#include "common/grid/cost_map.h"
#include "common/robot/robot.h"

namespace scanway::tools {

/// A sweep as its mapper placed it and as it lay in truth.
struct PlacedSweep {
  std::string name;
  bool accepted = false;
  double probability = 0.0;
  Pose T_map_scan = Pose::Identity();
  Pose T_ref_scan = Pose::Identity();
  Sweep sweep;
};

/// What `scanway replay` made of a log with truth.
struct ReplayedFolder {
  std::vector<PlacedSweep> sweeps;  ///< In the order of the log.
  CostMap cost_map;
  Robot robot;
};

/// Reads report.json, out.lcmlog and costmap.yaml. Throws InputError, also where a sweep lacks its truth.
ReplayedFolder read_replayed(const std::string& folder);

}  // namespace scanway::tools
