#pragma once

#include <cstdint>
#include <optional>

#include <Eigen/Core>

#include "modules/mapper/core/cloud/map_points.h"

namespace scanway {

/// A near-horizontal plane: z = height_m + slope_x * x + slope_y * y, in the frame of the points it was found in.
struct GroundPlane {
  double height_m = 0.0;
  double slope_x = 0.0;
  double slope_y = 0.0;
  double rms_m = 0.0;    ///< Of the vertical distances of its points.
  double area_m2 = 0.0;  ///< How much floor its points show, counted in squares of 0.2 m.

  double height_at(double x, double y) const { return height_m + slope_x * x + slope_y * y; }
  /// Distance of p from the plane, positive above it, metres.
  double distance(const Eigen::Vector3d& p) const;
};

struct GroundPlaneConfig {
  double max_slope = 0.2618;                ///< Radians from the horizontal.
  double inlier_m = 0.03;                   ///< Half the thickness of what counts as one plane.
  double min_area_m2 = 1.0;                 ///< Less floor than this is no ground.
  double max_range_m = 20.0;                ///< From the sensor, horizontally.
  double sensor_height_m = 0.0;             ///< Of the sensor above the ground, if known; 0: not known.
  double sensor_height_tolerance_m = 0.15;  ///< How far the ground may be from where the sensor's height puts it.
  std::uint64_t seed = 1;
};

/// The ground as one plane, by RANSAC across the robot's axis (z, along gravity) and least squares over its inliers
/// (Fischler and Bolles 1981). Planes above the sensor, such as a ceiling, are never candidates; what lies below a
/// candidate counts against it, so a table loses against the floor under it; floor near the robot counts for more,
/// because the robot stands on it. Each 0.2 m cube of space has one vote, so a plane wins by its area and not by how
/// densely it was scanned. Nothing, if no plane shows enough area: "no ground found".
std::optional<GroundPlane> find_ground_plane(const MapPoints& points, const GroundPlaneConfig& config);

}  // namespace scanway
