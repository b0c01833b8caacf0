#pragma once

#include "common/grid/bounds.h"
#include "common/grid/cost_map.h"
#include "common/picture/raster.h"

namespace scanway {

constexpr Colour kFreeColour = {255, 255, 255};
constexpr Colour kUnknownColour = {196, 196, 196};
constexpr Colour kOccupiedColour = {0, 0, 0};
constexpr Colour kLethalColour = {92, 124, 178};
constexpr Colour kDearestColour = {152, 190, 236};  ///< A cell of cost 1.0; cheaper ones are paler.

/// A part of the cost map in these colours; whole pixels a cell, or whole cells a pixel.
Raster raster_of(const CostMap& map, const CellRectangle& part);

}  // namespace scanway
