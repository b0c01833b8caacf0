#pragma once

#include <cstdint>
#include <vector>

#include "modules/mapper/core/cloud/map_points.h"
#include "modules/mapper/core/costmap/polar.h"
#include "modules/mapper/core/costmap/sweep_view.h"
#include "modules/mapper/core/ground/ground_surface.h"

namespace scanway {

/// How a sweep's beams follow the ground outwards, and where they went on below it: trenches, docks, kerbs seen from
/// above, stairs down.
///
/// Ground is carried 0.3 m beyond its last point, so it reaches over an edge. Between two beams of which one ends on
/// the ground and the next further out on the same ground there is ground, as far as one can know; where the next one
/// ends below the ground as it goes on from here, an edge lies anywhere between the two. In the polar cells of
/// SweepView this keeps the steepest beam over each and where it ended; where a return lies on the ground itself
/// nothing went through it.
class DropView {
 public:
  DropView(const MapPoints& points, const GroundSurface& ground, const SweepViewConfig& config);

  enum class Below {
    nothing,   ///< The ground goes on.
    unsure,    ///< The next beam ended below it, not to where it says how deep it is here.
    far_drop,  ///< It ended deeper than even ground falls over such a gap. A steep way down may look the same from
               ///< afar.
    drop,      ///< It ended deeper by a step, steeper than the robot can drive.
  };
  struct Way {
    Below below = Below::nothing;
    bool sparse = false;  ///< The beams on both sides end more than kSparse apart: between them low things may lie.
  };
  /// On the `ground` at a place about the sensor, or up to kEdge beyond it: an edge lies before what is seen past it.
  Way way(const polar::Place& place, const Eigen::Vector2d& direction, const GroundSurface::Place& ground) const;

  static constexpr double kEdge = 0.04;   ///< Metres.
  static constexpr double kSparse = 0.3;  ///< Metres.

 private:
  struct Beam {
    float slope;           ///< dz / horizontal range, of the steepest beam over the cell.
    std::uint16_t ends;    ///< Its bin.
    std::uint16_t begins;  ///< The last bin before, or this, with a return on the ground.
    bool on_ground;        ///< A return on the ground lies in this very cell,
    bool into_pit;         ///< one below the ground.
  };
  /// The ground in a direction: its height over the sensor (negative: below), and how it rises outwards: by the local
  /// slope, or by that of all the ground.
  struct Profile {
    double height, least_rise;
  };
  void add_returns(const MapPoints& points, const GroundSurface& ground);
  void follow_beams();
  double depth(const Beam& beam, int bin, const Profile& ground) const;
  /// Whether any beam about the place ends so low that below() need be asked.
  bool any_falls(const polar::Place& place, const Profile& ground) const;
  Below below(const Beam& beam, int bin, const Profile& ground) const;
  Below below_around(const polar::Place& place, const Profile& ground) const;
  const Beam& beam(int sector, int bin) const {
    return beams_[static_cast<std::size_t>((sector + polar::kSectors) % polar::kSectors) * bins_ + bin];
  }

  SweepViewConfig config_;
  Eigen::Vector3d origin_;
  GroundPlane plane_;
  int bins_;
  double steepest_;          ///< Slope that the robot can drive.
  std::vector<Beam> beams_;  ///< By sector, then bin.
};

}  // namespace scanway
