#pragma once

#include <span>

#include "modules/mapper/core/registration/cell_grid.h"

namespace scanway::registration {

/// For every point of a grid its neighbours within one radius (without itself), found once and shared by normals and
/// both passes of the features. Points are named by their position in the grid.
struct Neighbourhoods {
  std::vector<std::uint32_t> begin;  ///< Size of the grid + 1.
  std::vector<std::uint32_t> index;
  std::vector<float> squared_distance;

  std::span<const std::uint32_t> of(std::size_t i) const { return {index.data() + begin[i], begin[i + 1] - begin[i]}; }
};

Neighbourhoods find_neighbourhoods(const CellGrid& grid, float radius_m);

}  // namespace scanway::registration
