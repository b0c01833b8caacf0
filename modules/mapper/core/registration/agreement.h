#pragma once

#include "common/geometry/pose.h"
#include "modules/mapper/core/registration/prepared_scan.h"

namespace scanway::registration {

/// How well two scans agree at a pose, from the points that each saw.
struct Agreement {
  double overlap = 0.0;       ///< Share of source points with a target point within 0.3 m.
  double overlap_back = 0.0;  ///< Share of target points with a source point within 0.3 m.
  double conflict = 0.0;      ///< Share of points in the other's view that lie where the other saw through; the worse.
  double surface_fit = 0.0;   ///< Share of the surfaces in the other's view that meet a like one; the worse direction.
};

/// Poses are between the sensors' centres. `samples`: how many points a side are asked.
Agreement assess(const PreparedScan::Data& source, const PreparedScan::Data& target, const Pose& T_target_source,
                 std::size_t samples);

/// How the surfaces in common hold a shift along each of three axes.
struct Hold {
  /// Of the surfaces in the other's view, the share that lies within a few centimetres of a like one, each counted by
  /// how much it would hold a shift along an axis; of axes and directions the worst. A pose that the ground alone
  /// supports, while walls miss each other, has none of it.
  double fit = 0.0;
  /// Of the surfaces that do so, how many face along each axis, within 60 degrees; the lesser direction. The noise of
  /// normals adds up to information along a corridor, but it turns no wall to face that way.
  Eigen::Vector3d facing = Eigen::Vector3d::Zero();
};
Hold hold_of(const PreparedScan::Data& source, const PreparedScan::Data& target, const Pose& T_target_source,
             const Eigen::Matrix3d& axes);

/// Mean distance of some points of either scan to the nearest of the other, of which none counts more than 0.3 m.
double mean_gap(const PreparedScan::Data& source, const PreparedScan::Data& target, const Pose& T_target_source);

}  // namespace scanway::registration
