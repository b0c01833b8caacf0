#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "modules/mapper/core/octomap/key_grid.h"

namespace scanway {

/// A voxel's three 16-bit keys with their bits interleaved, x lowest: the path from an OctoMap's root to the voxel.
using MortonCode = std::uint64_t;

constexpr int kTreeLevels = 16;
constexpr std::array<MortonCode, 3> kAxisBits = {0x249249249249, 0x492492492492, 0x924924924924};

constexpr MortonCode morton_code(std::uint16_t x, std::uint16_t y, std::uint16_t z) {
  MortonCode code = 0;
  for (int bit = 0; bit < kTreeLevels; ++bit) {
    code |= ((MortonCode{x} >> bit & 1) | (MortonCode{y} >> bit & 1) << 1 | (MortonCode{z} >> bit & 1) << 2)
            << (3 * bit);
  }
  return code;
}
MortonCode morton_code(const octomap::OcTreeKey& key);

constexpr int kBrickLevel = 4;  ///< A brick is a cube of 2^4 voxels a side.
constexpr int kBrickBits = 3 * kBrickLevel;
constexpr std::size_t kBrickWords = (std::size_t{1} << kBrickBits) / 64;

/// What one sweep says of a cube of voxels, one bit a voxel in Morton order, so that every cube of 2^n voxels a side is
/// one run of bits.
struct VoxelBrick {
  std::array<std::uint64_t, kBrickWords> free{};
  std::array<std::uint64_t, kBrickWords> occupied{};

  /// A voxel that is occupied is no longer free as well.
  void prefer_occupied() {
    for (std::size_t w = 0; w < kBrickWords; ++w) free[w] &= ~occupied[w];
  }
};

/// The bricks that a sweep touches. A trie of three tables finds one, for a hash would be most of a ray's cost.
class VoxelBricks {
 public:
  using BrickNumber = std::uint64_t;  ///< The Morton code of its voxels without the last kBrickBits bits.

  static constexpr int kTableBits = (3 * kTreeLevels - kBrickBits) / 3;
  static constexpr std::size_t kTableSize = std::size_t{1} << kTableBits;
  using Table = std::array<VoxelBrick*, kTableSize>;

  /// The brick of that number; it is made when there is none.
  VoxelBrick& at(BrickNumber number) { return at(table_of(number), number); }
  /// The same in two steps, for who asks for many in one table: a cube of 16 bricks a side.
  Table& table_of(BrickNumber number);
  VoxelBrick& at(Table& table, BrickNumber number) {
    VoxelBrick*& brick = table[number % kTableSize];
    if (brick == nullptr) brick = make(number);
    return *brick;
  }
  /// Whether the voxel was not yet occupied.
  bool insert_occupied(MortonCode code);
  /// Adds the bits of `other`. The order of merging does not matter.
  void merge(const VoxelBricks& other);

  /// In increasing order: depth first through the tree.
  std::vector<BrickNumber> numbers() const;

 private:
  static constexpr std::size_t kBricksInSlab = 64;
  using Tables = std::array<std::unique_ptr<Table>, kTableSize>;

  VoxelBrick* make(BrickNumber number);

  std::array<std::unique_ptr<Tables>, kTableSize> tables_;
  // Of slabs, for single bricks among the small nodes of a tree make the heap's work long.
  std::vector<std::unique_ptr<VoxelBrick[]>> slabs_;
  std::vector<BrickNumber> numbers_;
};

}  // namespace scanway
