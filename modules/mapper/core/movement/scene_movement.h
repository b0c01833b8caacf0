#pragma once

#include <cstddef>

#include "common/geometry/pose.h"
#include "modules/mapper/core/registration/prepared_scan.h"

namespace scanway {

/// What stood in one of two sweeps where the other saw through: persons who walk about, doors, cars.
struct SceneMovement {
  std::size_t came = 0, gone = 0;  ///< Things of the sweep that the target saw through; of the target, the other way.
  double share = 0.0;              ///< Of both sweeps' points in the other's view: those of such things.
  double nearest_m = 0.0;          ///< Of these things, from the sweep's sensor.

  bool moved() const { return came + gone > 0; }
};

SceneMovement scene_movement(const PreparedScan::Data& sweep, const PreparedScan::Data& target,
                             const Pose& T_target_sweep);

}  // namespace scanway
