#pragma once

#include "common/random/random.h"
#include "modules/simulator/core/world/ground_plan.h"

namespace scanway::simulator {

/// A house of equal bays, as real ones are: windows at equal distances on every storey, and what its owners added.
struct Building {
  Rectangle plan;
  double ground_m = 0.0;
  int storeys = 2;
  double storey_m = 3.0;
  double bay_m = 3.2;
  Material wall = Material::plaster;
  bool gates = false;  ///< Wide openings on the ground floor instead of windows.
};

void add_building(Mesh& mesh, const Building& building, Random& random);

/// A plain wall between two points, `thickness` wide, from below the ground to `height` above `ground_m`.
void add_wall(Mesh& mesh, const Eigen::Vector2d& a, const Eigen::Vector2d& b, double ground_m, double height,
              double thickness, Surface surface);

}  // namespace scanway::simulator
