#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "modules/mapper/core/cloud/voxel_sums.h"

namespace scanway {

/// Appends sums, by key and all of them from `first_key` on, in some ten bytes each, without loss. Their points all
/// have an intensity, or none has; those of one voxel have one normal, and it takes bytes only where it is not that of
/// the voxel before.
void pack(std::span<const VoxelSum> sums, std::uint64_t first_key, bool with_intensity,
          std::vector<std::uint8_t>& bytes);

/// Appends what was packed.
void unpack(std::span<const std::uint8_t> bytes, std::uint64_t first_key, bool with_intensity,
            std::vector<VoxelSum>& sums);

}  // namespace scanway
