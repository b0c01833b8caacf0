#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "common/grid/cost_map.h"
#include "modules/mapper/core/cloud/map_points.h"
#include "modules/mapper/core/ground/ground_surface.h"

namespace scanway {

/// What a sweep's returns from one patch of ground show of what it is made of.
struct GroundPatch {
  int points = 0;
  double intensity = 0.0;  ///< Mean, as the device counts it.
  double range_m = 0.0;    ///< Mean distance from the sensor.
  double cosine = 0.0;     ///< Of the angle between the beams and the normal of the ground's surface.
  /// Standard deviation of the returns about the patch's own plane, metres along the beam: the range's noise and the
  /// ground's relief together, however flat the beam.
  double roughness_m = 0.0;
};

/// The patches of a sweep that show enough points for a plane, by their place: squares of kSide.
class GroundPatches {
 public:
  static constexpr double kSide = 0.4;     ///< Metres.
  static constexpr double kGrass_m = 0.1;  ///< Over and under the ground's surface: what belongs to it, with its grass.
  static constexpr int kFewest = 6;        ///< Points, and none to speak of up to 0.5 m above: walls have feet.
  static constexpr double kFlattest = 0.03;  ///< Cosine: flatter beams tell of nothing.

  /// Without intensities there are no patches.
  GroundPatches(const MapPoints& points, const GroundSurface& ground);

  static Cell place_of(double x, double y);
  const std::map<Cell, GroundPatch>& all() const { return patches_; }

 private:
  std::map<Cell, GroundPatch> patches_;
};

}  // namespace scanway
