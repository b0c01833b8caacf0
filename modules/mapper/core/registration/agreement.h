#pragma once

#include "modules/mapper/core/registration/icp.h"
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

/// Of the source's surfaces in the target's view, the share that lies within a few centimetres of a like one, each
/// counted by how much it would hold a shift along an axis; the worst of the three axes of the ICP's knowledge. A pose
/// that the ground alone supports, while walls miss each other, has none of it.
double held_fit(const PreparedScan::Data& source, const PreparedScan::Data& target, const IcpResult& icp);

}  // namespace scanway::registration
