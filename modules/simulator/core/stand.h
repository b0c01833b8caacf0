#pragma once

#include <optional>
#include <string>

#include "common/geometry/pose.h"
#include "common/robot/robot.h"
#include "modules/simulator/core/truth/truth_grid.h"
#include "modules/simulator/core/world/world.h"

namespace scanway::simulator {

/// Where the robot comes to stand when it is put down at (x, y) with that heading: its wheels, at the corners of the
/// footprint, on the ground below them.
struct Stand {
  Pose X_world_base = Pose::Identity();
  std::string problem;  ///< Why it cannot stand there, ends the sentence "the robot would stand ..."; empty if it can.
};

Stand stand_at(const World& world, const Robot& robot, const Place& place);

/// The same by a grid that reaches the robot's circumscribed circle, without looking for the ground: what is wrong with
/// the first cell under the footprint that the robot cannot be over; empty if there is none.
std::string problem_on(const TruthGrid& truth, const World& world, const Robot& robot, const Place& place);

constexpr double kTruthCell_m = 0.01;

}  // namespace scanway::simulator
