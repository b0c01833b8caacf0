#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "common/geometry/pose.h"
#include "common/progress/stages.h"
#include "common/robot/robot.h"
#include "modules/mapper/core/cloud/map_points.h"
#include "modules/mapper/core/costmap/evidence.h"
#include "modules/mapper/core/ground/ground_plane.h"

namespace scanway {

/// What is known of the ground in one sweep. Without a plane there is no ground model: the sweep then says nothing
/// about what is free or occupied, and the cost map stays as it was.
struct GroundReport {
  std::optional<GroundPlane> plane;  ///< In the map frame.
  double sensor_height_m = 0.0;      ///< Of the sensor above the plane, where there is one.
  double surface_area_m2 = 0.0;      ///< Of the floor on which a robot can stand, as far as it was seen.
  bool height_known = false;         ///< It was looked for only where the sensor's height puts it.
};

/// For people, to follow another sentence. Empty: there is ground.
std::string said_of(const GroundReport& ground);

/// `sensor_height_m`: of the sensor above the ground below it, if known. `seed`: of the search for the plane.
GroundReport find_ground(const MapPoints& points, std::optional<double> sensor_height_m, const Robot& robot,
                         std::uint64_t seed);

/// How far from a sensor the cost map is drawn, metres, horizontally.
constexpr double kCostMapReach = 30.0;

/// What one sweep says of the ground, and of what stands on it; without ground nothing.
struct Look {
  GroundReport ground;
  SweepEvidence evidence;
};

/// `sweep` and its usable points in the map; cells of the resolution that the robot file says.
Look look(const MapPoints& points, const Sweep& sweep, const Pose& X_map_sweep, const Robot& robot, std::uint64_t seed,
          StageListener* stages = nullptr);

}  // namespace scanway
