#pragma once

#include "modules/mapper/core/registration/cell_grid.h"
#include "modules/mapper/core/registration/keypoints.h"
#include "modules/mapper/core/registration/range_image.h"
#include "modules/mapper/core/registration/registration.h"
#include "modules/mapper/core/registration/surfaces.h"

namespace scanway {

/// Everything is relative to the sensor's centre, so that single precision serves wherever the scan lies.
struct PreparedScan::Data {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< The sensor's centre in the scan's frame.
  registration::CellGrid fine;                       ///< Voxel centroids at 0.1 m.
  registration::RangeImage image;
  registration::Surfaces surfaces;
  registration::Surfaces few_surfaces, fewest_surfaces;  ///< For the first, coarse rounds of the ICP.
  registration::CellGrid surface_grid;
  registration::Keypoints keypoints;
  /// As many of them as go with that many sampled points.
  const registration::Surfaces& surfaces_for(std::size_t samples) const {
    if (samples <= fewest_surfaces.count()) return fewest_surfaces;
    return samples < surfaces.count() ? few_surfaces : surfaces;
  }
  std::string defect;  ///< Why the scan cannot be registered; empty if it can.
};

}  // namespace scanway
