#pragma once

#include <cstdint>
#include <vector>

#include "common/cloud/sweep.h"
#include "common/geometry/pose.h"
#include "common/robot/robot.h"
#include "modules/simulator/core/truth/rasterizer.h"
#include "modules/simulator/core/world/world.h"

namespace scanway::tools {

/// A sweep, in `base`, and where it was taken in truth.
struct TrueSweep {
  const Sweep* sweep = nullptr;
  Pose X_world_base = Pose::Identity();
};

/// For each cell of a window of the world, what some sweeps saw of its ground in truth: by the world's geometry and
/// where the points lie, not by what a mapper makes of them.
struct SeenGround {
  simulator::CellWindow window;
  std::vector<std::uint8_t> near;     ///< How many sweeps have a point on the ground within kGroundReach_m.
  std::vector<std::uint8_t> visible;  ///< How many of these look onto the ground at the cell's centre.
};

constexpr double kGroundReach_m = 0.3;  ///< So far ground points carry the ground between them.

/// `window`: whole cells from the world's origin.
SeenGround seen_ground(const simulator::World& world, const Robot& robot, const std::vector<TrueSweep>& sweeps,
                       const simulator::CellWindow& window);

/// Of some cells of the window, by their index: how many sweeps look onto the ground at the centre and at all of the
/// air above it that the body needs, up to what a thing of kAirGap_m leaves open. Floor that is seen below a car is not
/// among them.
std::vector<std::uint8_t> seen_with_air(const simulator::World& world, const Robot& robot,
                                        const std::vector<TrueSweep>& sweeps, const simulator::CellWindow& window,
                                        const std::vector<std::size_t>& cells);

constexpr double kAirGap_m = 0.1;

}  // namespace scanway::tools
