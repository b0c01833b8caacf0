#pragma once

#include <cstdint>
#include <vector>

#include "modules/mapper/core/cloud/map_points.h"
#include "modules/mapper/core/costmap/obstacle_returns.h"
#include "modules/mapper/core/costmap/polar.h"
#include "modules/mapper/core/ground/ground_surface.h"

namespace scanway {

/// What a sweep's beams passed over, in polar cells about the sensor: sectors of an eighth of a degree, bins of 2 cm.
///
/// A beam that ended at a return passed over every bin before it, at a height that falls (or rises) evenly. For each
/// polar cell this keeps the lowest such beam. What lies below the lowest beam over a place was not seen to be absent;
/// what lies on the ground behind a low obstacle therefore stays unknown until a beam comes down to it. Returns from
/// below the ground (mirrors, wet floor, pits) are no evidence of anything above it and are left out.
///
/// Behind a return from an obstacle, but not beyond where its beam would have reached the ground, the beam's further
/// way is hidden. It is for 0.5 m where the sensor looks down upon the obstacle: it shows how deep it is by returns
/// from its top, however sparse, and these must not open it between them. It is without end where the obstacle reaches
/// up to the sensor, or as high as the body: nothing shows its depth, and beams that go on below it (a car, a bench)
/// see floor that it covers. Ground that lies as high as the return itself is not hidden by it (the top of a kerb, by
/// the kerb's face), unless that ground leans: slabs of rubble do.
///
/// A beam that met nothing passed over everything as far as kMissingRange, or to where it would have come down:
/// further out a thing may be too dark for it.
///
/// Clouds are thinned in many ways: between two returns that are a thinning step apart, the beams have been thrown
/// away. A polar cell looks at the sectors within 3/4 of that step, at least one on each side, for the lowest beam and
/// for what hides it. The step is the median distance of a return to its nearest neighbour, at most 0.15 m.
class SweepView {
 public:
  /// `missing`: unit directions in the map of beams that met nothing.
  SweepView(const MapPoints& points, const std::vector<Eigen::Vector3f>& missing, const GroundSurface& ground,
            const std::vector<ObstacleReturn>& obstacles, const SweepViewConfig& config);

  /// Whether the air over the ground at a place about the sensor was seen to be empty from the climbable step upwards:
  /// the lowest beam passed within the step, the range's deviation, its own half width and the thinning of it.
  bool seen_empty(const polar::Place& place, const GroundSurface::Place& ground) const;

  /// The median distance of returns, metres.
  double spacing_m() const { return spacing_; }
  static constexpr double kMissingRange = 10.0;  ///< Metres, horizontally.

  const Eigen::Vector3d& origin() const { return origin_; }  ///< The sensor, in the map.
  double max_range_m() const { return config_.max_range_m; }
  const SweepViewConfig& config() const { return config_; }

 private:
  void add_beams(const MapPoints& points, const GroundSurface& ground);
  void add_missing(const std::vector<Eigen::Vector3f>& directions, double sensor_above);
  void pass_on();
  void hide_behind(const std::vector<ObstacleReturn>& obstacles);
  void look_around();
  bool leans(const GroundSurface::Place& ground) const;

  SweepViewConfig config_;
  Eigen::Vector3d origin_;
  GroundPlane plane_;
  double spacing_ = 0.0;
  int bins_ = 0;
  std::vector<float> lowest_;  ///< By sector, then bin: the least slope (dz / horizontal range) of beams over it.
  std::vector<float> hidden_;  ///< By sector, then bin: how high over the sensor what hides it rises.
};

}  // namespace scanway
