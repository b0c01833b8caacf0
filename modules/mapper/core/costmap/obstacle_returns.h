#pragma once

#include <vector>

#include "modules/mapper/core/cloud/map_points.h"
#include "modules/mapper/core/ground/ground_surface.h"

namespace scanway {

/// What a sweep's returns and beams are judged by.
struct SweepViewConfig {
  double body_height_m = 1.5;
  double climbable_step_m = 0.02;
  double range_sigma_m = 0.01;
  double divergence = 0.0047;       ///< Full angle of a beam, radians.
  double climbable_slope = 0.2618;  ///< Radians.
  double max_range_m = 30.0;        ///< From the sensor, horizontally: nothing is called seen or occupied beyond.
};

/// A return from something that the robot's body would hit.
struct ObstacleReturn {
  float x, y;         ///< In the map, metres.
  float range;        ///< From the sensor, horizontally.
  float from_sensor;  ///< Its height over the sensor, metres; below it negative.
  float above;        ///< Its height over the local ground.
  int sector;         ///< polar::sector_of.
};

/// Whether a return `above` metres over the local ground, seen from a sensor `drop` metres above it at `range`, is from
/// an obstacle. The range's noise moves it along the beam, so up or down by sigma * drop / range: floor under a steep
/// beam is noisier than far floor. An obstacle is what no floor shows in a sweep: over the climbable step by one
/// deviation (the paper's band), and over five deviations of the height. One such return is enough.
bool is_obstacle_return(double above, double drop, double range, const SweepViewConfig& config);

/// The obstacle returns of a sweep, by sector and range. A return that noise has thrown off a surface is left out: one
/// with at least four times as many returns of its sector around some place within four deviations before or behind it
/// than around itself (within one deviation each). A lone return has no such neighbours and stays. Without this a wall
/// at 1 cm noise is 7 cm thick.
std::vector<ObstacleReturn> obstacle_returns(const MapPoints& points, const GroundSurface& ground,
                                             const SweepViewConfig& config);

}  // namespace scanway
