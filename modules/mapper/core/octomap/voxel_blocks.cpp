#include "modules/mapper/core/octomap/voxel_blocks.h"

#include <bit>
#include <cstring>

namespace scanway {
namespace {

/// Set in the numbers of blocks of many values.
constexpr BlockNumber kMany = BlockNumber{1} << 31;
static_assert(kMany > kLastBlock);

bool has_many(BlockNumber number) { return (number & kMany) != 0; }

// Of four children side by side.
typedef float Values __attribute__((vector_size(16)));
typedef std::int32_t Bits __attribute__((vector_size(16)));

constexpr Bits kLowBits = {1, 2, 4, 8}, kHighBits = {16, 32, 64, 128};

/// A bit for each child of whom it is true.
std::uint32_t places(Bits low, Bits high) {
  const Bits bits = (low & kLowBits) | (high & kHighBits);
  return static_cast<std::uint32_t>((bits[0] | bits[1]) | (bits[2] | bits[3]));
}

/// False when there are more than three values.
bool shorten(const VoxelBlock& block, FewVoxelValues& few) {
  Values low, high;
  std::memcpy(&low, &block.log_odds[0], sizeof(low));
  std::memcpy(&high, &block.log_odds[4], sizeof(high));
  std::uint32_t left = places(low == low, high == high);
  for (std::size_t k = 0; k < few.log_odds.size(); ++k) {
    const float value = block.log_odds[static_cast<std::size_t>(std::countr_zero(left | 128))];
    const std::uint32_t here = left & places(low == value, high == value);
    few.log_odds[k] = value;
    few.places[k] = static_cast<std::uint8_t>(here);
    left &= ~here;
  }
  return left == 0;
}

Values four_of(const FewVoxelValues& few, Bits bits) {
  Values values = Values{} + kNoNode;
  for (std::size_t k = 0; k < few.log_odds.size(); ++k) {
    const Bits here = (bits & std::int32_t{few.places[k]}) != 0;
    values = here ? Values{} + few.log_odds[k] : values;
  }
  return values;
}

VoxelBlock lengthened(const FewVoxelValues& few) {
  const Values low = four_of(few, kLowBits), high = four_of(few, kHighBits);
  VoxelBlock block;
  std::memcpy(&block.log_odds[0], &low, sizeof(low));
  std::memcpy(&block.log_odds[4], &high, sizeof(high));
  return block;
}

}  // namespace

VoxelBlock VoxelBlocks::operator[](BlockNumber number) const {
  return has_many(number) ? many[number & ~kMany] : lengthened(few[number]);
}

BlockNumber VoxelSupply::put(BlockNumber number, const VoxelBlock& values) {
  FewVoxelValues few;
  const bool many = !shorten(values, few);
  if (number != 0 && has_many(number) != many) {
    give_back(number);
    number = 0;
  }
  if (number == 0) number = many ? many_.take() | kMany : few_.take();
  if (many) {
    blocks_.many[number & ~kMany] = values;
  } else {
    blocks_.few[number] = few;
  }
  return number;
}

void VoxelSupply::give_back(BlockNumber number) {
  if (has_many(number)) return many_.give_back(number & ~kMany);
  few_.give_back(number);
}

}  // namespace scanway
