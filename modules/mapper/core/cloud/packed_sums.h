#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "modules/mapper/core/cloud/voxel_sums.h"

namespace scanway {

/// Packs sums, by key and all of them from `first_key` on, in some ten bytes each, without loss. Their points all
/// have an intensity, or none has; those of one voxel have one normal, and it takes bytes only where it is not that of
/// the voxel before.
class SumPacker {
 public:
  SumPacker(std::uint64_t first_key, bool with_intensity) : key_(first_key), with_intensity_(with_intensity) {}

  /// Appends to `bytes` the sums that follow.
  void pack(std::span<const VoxelSum> sums, std::vector<std::uint8_t>& bytes);

 private:
  std::uint8_t* put(const VoxelSum& voxel, std::uint8_t* to);

  std::uint64_t key_;
  std::array<std::int32_t, 3> normal_{};
  bool with_intensity_;
};

/// Reads what was packed, which must stay as long as this.
class SumReader {
 public:
  SumReader(std::span<const std::uint8_t> bytes, std::uint64_t first_key, bool with_intensity);

  bool at_end() const { return at_end_; }
  std::uint64_t next_key() const { return key_; }  ///< Of the sum that is read next.
  /// Appends all sums before that key.
  void read_until(std::uint64_t end_key, std::vector<VoxelSum>& sums);

 private:
  void step();
  std::uint64_t take_number();

  const std::uint8_t* at_;
  const std::uint8_t* end_;
  std::uint64_t key_;
  std::array<std::int32_t, 3> normal_{};
  bool with_intensity_, at_end_ = false;
};

}  // namespace scanway
