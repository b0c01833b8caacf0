#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "common/cloud/sweep.h"

namespace scanway::testing {

/// An axis-aligned solid, metres.
struct Box {
  Eigen::Vector3d low, high;
};

/// A world of boxes over the plane z = 0, ray-cast by itself: independent of whatever it tests.
struct Scene {
  std::vector<Box> boxes;

  /// Range along the unit direction to the nearest surface, or infinity.
  double cast(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction) const;
  /// Whether nothing stands between the two points.
  bool visible(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const;
  /// Whether any box reaches into the cell's square between the heights low (exclusive) and high.
  bool blocks(double x, double y, double side, double low, double high) const;
};

/// A sweep of a laser that scans a vertical plane and pans about z: every beam of it, at `origin`, with Gaussian noise
/// of the range. The sweep's frame is the scene's, its origin at the sensor's place.
Sweep scan(const Scene& scene, const Eigen::Vector3d& origin, double pan_step_deg, double beam_step_deg,
           double range_sigma, std::uint64_t seed);

/// A room of 6 m x 5 m with a corridor behind a doorway, a table, a pillar, a shelf above 1.5 m, a slab of 2 cm and one
/// of 5 cm.
Scene furnished_room();

}  // namespace scanway::testing
