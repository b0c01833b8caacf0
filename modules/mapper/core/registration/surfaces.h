#pragma once

#include "modules/mapper/core/registration/cell_grid.h"

namespace scanway::registration {

/// Small flat pieces of surface, each the mean of the points of one cell: "the points that belong to specific geometric
/// surfaces", on which the ICP works. Cells are `kSurfaceCell` wide; where a cell holds no plane (beams far apart), the
/// next coarser level is asked.
struct Surfaces {
  Points centre;
  Points normal;                ///< Unit, towards the sensor.
  std::vector<float> weight;    ///< Balances directions: rare directions of normals count more. About 1 in the mean.
  std::vector<float> variance;  ///< Of the centre along the normal, by the points' scatter, square metres.
  std::vector<float> size;      ///< Edge of the cell that it was taken from, metres.
  std::size_t count() const { return centre.size(); }
};

constexpr float kSurfaceCell = 0.4f;

/// The flat pieces of a scan, in the order of their cells, finest level first.
Surfaces choose_surfaces(const Points& points);

/// At most `count` of them, evenly spread by weight: for the first, coarse rounds.
Surfaces thin_surfaces(const Surfaces& surfaces, std::size_t count);

}  // namespace scanway::registration
