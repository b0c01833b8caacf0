#include "modules/mapper/core/octomap/voxel_blocks.h"

#include <gtest/gtest.h>

#include <cstring>
#include <map>
#include <set>
#include <vector>

#include "common/random/random.h"

namespace scanway {
namespace {

/// Of at most `values` different values; some children are absent.
VoxelBlock random_block(Random& random, std::size_t values) {
  std::vector<float> of{kNoNode};
  while (of.size() <= values) of.push_back(static_cast<float>(random.normal()));
  VoxelBlock block;
  for (float& value : block.log_odds) value = of[random.below(of.size())];
  return block;
}

bool same_bytes(const VoxelBlock& a, const VoxelBlock& b) { return std::memcmp(&a, &b, sizeof(a)) == 0; }

std::size_t different_values(const VoxelBlock& block) {
  std::set<float> values;
  for (std::size_t i = 0; i < 8; ++i) {
    if (block.has(i)) values.insert(block.log_odds[i]);
  }
  return values.size();
}

TEST(VoxelBlocks, HoldWhatWasPutLast) {
  Random random(8);
  VoxelBlocks blocks;
  VoxelSupply supply(blocks);
  std::map<BlockNumber, VoxelBlock> held;
  std::vector<std::size_t> seen(9);
  for (int step = 0; step < 20'000; ++step) {
    const VoxelBlock block = random_block(random, random.below(3) == 0 ? 100 : random.below(9));
    ++seen[different_values(block)];
    BlockNumber number = 0;
    if (held.size() > 300) {
      number = std::next(held.begin(), static_cast<std::ptrdiff_t>(random.below(held.size())))->first;
      held.erase(number);
      if (random.below(3) == 0) supply.give_back(std::exchange(number, 0));
    }
    number = supply.put(number, block);
    ASSERT_NE(number, 0u);
    ASSERT_TRUE(held.emplace(number, block).second) << "two blocks in one place";
    if (step % 500 != 0) continue;
    for (const auto& [at, values] : held) ASSERT_TRUE(same_bytes(blocks[at], values));
  }
  for (const std::size_t count : seen) EXPECT_GT(count, 20u);
}

}  // namespace
}  // namespace scanway
