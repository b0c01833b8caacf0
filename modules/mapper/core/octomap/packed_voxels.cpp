#include "modules/mapper/core/octomap/packed_voxels.h"

#include <iterator>

namespace scanway {

PackedBrick::PackedBrick(VoxelBrick brick) {
  brick.prefer_occupied();
  free_ = pack(brick.free);
  occupied_ = pack(brick.occupied);
  mixed_words_.shrink_to_fit();
}

PackedBrick::Half PackedBrick::pack(const std::array<std::uint64_t, kBrickWords>& words) {
  Half half;
  for (std::size_t w = 0; w < kBrickWords; ++w) {
    const std::uint64_t bit = std::uint64_t{1} << w;
    if (words[w] == ~std::uint64_t{0}) {
      half.full |= bit;
    } else if (words[w] != 0) {
      half.mixed |= bit;
      mixed_words_.push_back(words[w]);
    }
  }
  return half;
}

VoxelBrick PackedBrick::unpacked() const {
  VoxelBrick brick;
  auto mixed = mixed_words_.begin();
  const auto unpack = [&](const Half& half, std::array<std::uint64_t, kBrickWords>& words) {
    for (std::size_t w = 0; w < kBrickWords; ++w) {
      if (half.full >> w & 1) words[w] = ~std::uint64_t{0};
      if (half.mixed >> w & 1) words[w] = *mixed++;
    }
  };
  unpack(free_, brick.free);
  unpack(occupied_, brick.occupied);
  return brick;
}

void VoxelHistory::put(SweepNumber sweep, VoxelBricks& bricks) {
  for (const VoxelBricks::BrickNumber number : bricks.numbers()) {
    bricks_[number].emplace(sweep, PackedBrick(bricks.at(number)));
  }
}

std::vector<VoxelBricks::BrickNumber> VoxelHistory::forget(SweepNumber sweep) {
  std::vector<VoxelBricks::BrickNumber> touched;
  for (auto brick = bricks_.begin(); brick != bricks_.end();) {
    if (brick->second.erase(sweep) > 0) touched.push_back(brick->first);
    brick = brick->second.empty() ? bricks_.erase(brick) : std::next(brick);
  }
  return touched;
}

const VoxelHistory::BrickHistory& VoxelHistory::of(VoxelBricks::BrickNumber number) const {
  static const BrickHistory kNone;
  const auto brick = bricks_.find(number);
  return brick == bricks_.end() ? kNone : brick->second;
}

}  // namespace scanway
