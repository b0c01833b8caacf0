#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "modules/mapper/core/octomap/voxel_bricks.h"

namespace scanway {

/// Appends a brick, without loss except that a voxel that is occupied is no longer free as well: words of which all
/// bits are set, or none, take a bit each.
void pack(VoxelBrick brick, std::vector<std::uint8_t>& bytes);

/// What was packed at `packed`, and how many bytes that took.
VoxelBrick unpacked_brick(const std::uint8_t* packed);
std::size_t packed_size(const std::uint8_t* packed);

}  // namespace scanway
