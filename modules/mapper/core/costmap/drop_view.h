#pragma once

#include <cstdint>
#include <vector>

#include "modules/mapper/core/cloud/map_points.h"
#include "modules/mapper/core/costmap/sweep_view.h"
#include "modules/mapper/core/ground/ground_surface.h"

namespace scanway {

/// Where a sweep's beams went on below the ground that is expected from around: trenches, docks, stairs down.
///
/// Ground is carried 0.3 m beyond its last point, so it reaches over an edge. There a beam passes below it, at first by
/// nothing and further out by more, and ends at something deeper. In the polar cells of SweepView this keeps the
/// steepest beam over each and where it ended; where a return lies on the ground itself nothing went through it.
class DropView {
 public:
  DropView(const MapPoints& points, const GroundSurface& ground, const SweepViewConfig& config);

  enum class Below {
    nothing,   ///< No beam passed below the ground.
    passed,    ///< One did, not to where it says how deep it is there.
    far_drop,  ///< It ended deeper than even ground falls over such a gap. A steep way down may look the same from
               ///< afar.
    drop,      ///< It ended deeper by a step, steeper than the robot can drive.
  };
  /// Below the ground expected at (x, y) or up to kEdge beyond it: an edge lies before what is seen past it.
  Below below(double x, double y, double ground_height) const;

  static constexpr double kEdge = 0.04;  ///< Metres.

 private:
  struct Beam {
    float slope;         ///< dz / horizontal range.
    std::uint16_t ends;  ///< The bin.
    bool on_ground;      ///< A return on the ground lies in this very cell,
    bool into_pit;       ///< one below the ground.
  };
  void follow_beams();
  Below below(std::size_t sector, int bin, double sensor_above) const;

  SweepViewConfig config_;
  Eigen::Vector3d origin_;
  int bins_;
  double steepest_;          ///< Slope that the robot can drive.
  std::vector<Beam> beams_;  ///< By sector, then bin.
};

}  // namespace scanway
