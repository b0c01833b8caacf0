#include "modules/mapper/core/cloud/packed_sums.h"

#include <limits>

#include <gtest/gtest.h>

#include "common/random/random.h"

namespace scanway {
namespace {

/// Of every length in bits.
std::uint64_t any_number(Random& random, std::uint64_t most_bits) {
  return random.below((std::uint64_t{1} << (1 + random.below(most_bits))));
}

std::vector<VoxelSum> any_sums(Random& random, bool with_intensity) {
  std::vector<VoxelSum> sums;
  std::uint64_t key = std::uint64_t{1} << 62;
  std::array<std::int32_t, 3> normal{};
  for (int i = 0; i < 1000; ++i) {
    VoxelSum& voxel = sums.emplace_back();
    voxel.key = key += 1 + any_number(random, 40);
    voxel.count = static_cast<std::uint32_t>(1 + any_number(random, 24));
    for (std::uint64_t& sum : voxel.offset_sum) sum = any_number(random, 34);
    if (with_intensity) {
      voxel.with_intensity = voxel.count;
      voxel.intensity_sum = static_cast<std::int64_t>(any_number(random, 62)) * (i % 2 == 0 ? 1 : -1);
    }
    if (i % 5 == 0) {
      for (std::int32_t& component : normal) component = static_cast<std::int32_t>(random.below(255)) - 127;
    }
    voxel.set_normal(normal);
  }
  return sums;
}

TEST(PackedSums, AreReadAsTheyWerePackedInWhateverParts) {
  Random random(1);
  for (const bool with_intensity : {false, true}) {
    const std::vector<VoxelSum> sums = any_sums(random, with_intensity);
    std::vector<std::uint8_t> bytes;
    SumPacker packer(std::uint64_t{1} << 62, with_intensity);
    packer.pack(std::span(sums).first(300), bytes);
    packer.pack(std::span(sums).subspan(300), bytes);
    SumReader reader(bytes, std::uint64_t{1} << 62, with_intensity);
    std::vector<VoxelSum> read;
    reader.read_until(sums[700].key, read);
    ASSERT_EQ(read.size(), 700u);
    EXPECT_EQ(reader.next_key(), sums[700].key);
    reader.read_until(std::numeric_limits<std::uint64_t>::max(), read);
    EXPECT_TRUE(reader.at_end());
    EXPECT_EQ(read, sums);
  }
}

TEST(PackedSums, OfNoVoxelAreAtTheirEnd) { EXPECT_TRUE(SumReader({}, 0, true).at_end()); }

}  // namespace
}  // namespace scanway
