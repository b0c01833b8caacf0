#pragma once

#include <string>

#include "modules/mapper/core/movement/robot_movement.h"
#include "modules/mapper/core/movement/scene_movement.h"

namespace scanway {

/// What did not stand still while a sweep was taken.
struct Movement {
  RobotMovement robot;
  /// The sweep that it was registered to, where the robot may have moved during that one instead: of two sweeps that
  /// contradict each other, either may be the one that is bent. Empty: it was this one.
  std::string or_during;
  SceneMovement scene;  ///< Since the sweep that it is registered to began.
};

/// Whether the robot moved so far that no one pose of the sweep is right within 0.1 m and 0.5 degrees.
bool breaks_sweep(const RobotMovement& movement);

/// For people, whole sentences; empty: all stood still, as far as it is known.
std::string said_of(const Movement& movement);

}  // namespace scanway
