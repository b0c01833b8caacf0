#pragma once

#include <string>

#include "common/grid/bounds.h"
#include "common/grid/cost_map.h"

namespace scanway {

/// Maps on disk, by the convention of ROS's map_server: a YAML file (image, resolution, origin, negate, thresholds)
/// and a PGM picture beside it, whose lower left corner lies at `origin`.

/// The map of the YAML file at `path`: states only, no costs; cell (0, 0) is the picture's lower left pixel. Reads PGM
/// with 8 or 16 bits, ASCII (P2) or binary (P5), and mode `trinary`. Keys of other programs are left aside, as
/// map_server does; one that is nearly a key of ours is a fault. Throws InputError.
CostMap read_map(const std::string& path);

/// A map and all the cells that its picture covers, an unknown rim too.
struct PicturedMap {
  CostMap map;
  CellRectangle extent;
};
PicturedMap read_pictured_map(const std::string& path);

/// Writes the known part of `map` as `path` (ends with .yaml) and the picture of the same name with .pgm: occupied 0,
/// free 254, unknown 205. A map without a known cell becomes a picture of one unknown cell. Throws InputError; each of
/// the two files is then either the old one or the new one.
void write_map(const CostMap& map, const std::string& path);

}  // namespace scanway
