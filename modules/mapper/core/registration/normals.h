#pragma once

#include "modules/mapper/core/registration/neighbourhoods.h"

namespace scanway::registration {

/// The local surface at each point, by the eigenvalues l0 <= l1 <= l2 of the neighbours' covariance.
struct Normals {
  Points normal;                 ///< Unit, towards the sensor (the frame's origin); zero where there is no surface.
  std::vector<float> curvature;  ///< l0 / (l0 + l1 + l2): 0 on a plane, at most 1/3.
};

/// From the neighbours within `radius_m` (at most the neighbourhoods' own radius), itself included. A point with fewer
/// than three of them, or with all on one line, has no normal.
Normals estimate_normals(const Points& points, const Neighbourhoods& neighbourhoods, float radius_m);

}  // namespace scanway::registration
