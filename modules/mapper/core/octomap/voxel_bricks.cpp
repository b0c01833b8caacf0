#include "modules/mapper/core/octomap/voxel_bricks.h"

#include <algorithm>
#include <utility>

namespace scanway {
namespace {

constexpr std::array<std::uint32_t, 256> spread_table() {
  std::array<std::uint32_t, 256> table{};
  for (std::uint16_t byte = 0; byte < 256; ++byte) table[byte] = static_cast<std::uint32_t>(morton_code(byte, 0, 0));
  return table;
}
constexpr std::array<std::uint32_t, 256> kSpread = spread_table();

MortonCode spread(std::uint16_t key) { return kSpread[key & 255] | MortonCode{kSpread[key >> 8]} << 24; }

}  // namespace

MortonCode morton_code(const octomap::OcTreeKey& key) {
  return spread(key[0]) | spread(key[1]) << 1 | spread(key[2]) << 2;
}

VoxelBricks::Table& VoxelBricks::table_of(BrickNumber number) {
  std::unique_ptr<Tables>& tables = tables_[number >> (2 * kTableBits)];
  if (!tables) tables = std::make_unique<Tables>();
  std::unique_ptr<Table>& table = (*tables)[number >> kTableBits & (kTableSize - 1)];
  if (!table) table = std::make_unique<Table>();
  return *table;
}

VoxelBrick* VoxelBricks::make(BrickNumber number) {
  const std::size_t in_slab = numbers_.size() % kBricksInSlab;
  if (in_slab == 0) slabs_.push_back(std::make_unique<VoxelBrick[]>(kBricksInSlab));
  numbers_.push_back(number);
  return &slabs_.back()[in_slab];
}

bool VoxelBricks::insert_occupied(MortonCode code) {
  std::uint64_t& word = at(code >> kBrickBits).occupied[code / 64 % kBrickWords];
  const std::uint64_t bit = std::uint64_t{1} << (code % 64);
  const bool is_new = (word & bit) == 0;
  word |= bit;
  return is_new;
}

void VoxelBricks::merge(const VoxelBricks& other) {
  for (std::size_t n = 0; n < other.numbers_.size(); ++n) {
    VoxelBrick& to = at(other.numbers_[n]);
    const VoxelBrick& from = other.slabs_[n / kBricksInSlab][n % kBricksInSlab];
    for (std::size_t w = 0; w < kBrickWords; ++w) {
      to.free[w] |= from.free[w];
      to.occupied[w] |= from.occupied[w];
    }
  }
}

std::vector<VoxelBricks::BrickNumber> VoxelBricks::numbers() const {
  std::vector<BrickNumber> sorted = numbers_;
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

}  // namespace scanway
