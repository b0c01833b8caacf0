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

VoxelBricks::VoxelBricks() : tables_(std::size_t{1} << (3 * kTreeLevels - kBrickBits - kTableBits)) {}

VoxelBrick& VoxelBricks::at(BrickNumber number) {
  Table& table = tables_[number >> kTableBits];
  if (table.empty()) table.resize(std::size_t{1} << kTableBits);
  std::unique_ptr<VoxelBrick>& brick = table[number & ((BrickNumber{1} << kTableBits) - 1)];
  if (!brick) {
    brick = std::make_unique<VoxelBrick>();
    numbers_.push_back(number);
  }
  return *brick;
}

bool VoxelBricks::insert_occupied(MortonCode code) {
  std::uint64_t& word = at(code >> kBrickBits).occupied[code / 64 % kBrickWords];
  const std::uint64_t bit = std::uint64_t{1} << (code % 64);
  const bool is_new = (word & bit) == 0;
  word |= bit;
  return is_new;
}

void VoxelBricks::merge(VoxelBricks&& other) {
  for (const BrickNumber number : other.numbers_) {
    VoxelBrick& to = at(number);
    const VoxelBrick& from = other.at(number);
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
