#include "common/parallel/blocks.h"

#include <atomic>

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "common/random/random.h"

namespace scanway {
namespace {

TEST(Blocks, CoverEveryIndexOnce) {
  for (const std::size_t n : {0u, 1u, 63u, 64u, 65u, 1000u}) {
    std::vector<std::atomic<int>> visits(n);
    for_blocks(n, 64, [&](std::size_t begin, std::size_t end, std::size_t block) {
      EXPECT_EQ(begin, block * 64);
      EXPECT_TRUE(end - begin == 64 || end == n);
      for (std::size_t i = begin; i < end; ++i) ++visits[i];
    });
    for (const auto& count : visits) EXPECT_EQ(count, 1);
  }
}

TEST(Blocks, SumsHaveTheSameBitsForEveryNumberOfThreads) {
  Random random(9);
  std::vector<double> values(100003);
  for (double& value : values) value = random.normal() * (1 + static_cast<double>(random.below(1000000)));
  const auto sum = [&](std::size_t block) {
    return sum_blocks(values.size(), block, 0.0, [&](std::size_t begin, std::size_t end) {
      double part = 0;
      for (std::size_t i = begin; i < end; ++i) part += values[i];
      return part;
    });
  };
  // The order that the header promises, written out.
  double expected = 0;
  for (std::size_t begin = 0; begin < values.size(); begin += 128) {
    double part = 0;
    for (std::size_t i = begin; i < std::min(values.size(), begin + 128); ++i) part += values[i];
    expected += part;
  }
  for (const std::size_t threads : {1u, 2u, 3u, 8u}) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    for (int round = 0; round < 20; ++round) ASSERT_EQ(sum(128), expected);
  }
  EXPECT_NE(sum(127), expected);  // the blocks matter: these values can tell orders apart
}

TEST(Blocks, AnExceptionReachesTheCaller) {
  const auto fail = [](std::size_t, std::size_t, std::size_t block) {
    if (block == 5) throw std::runtime_error("five");
  };
  EXPECT_THROW(for_blocks(1000, 10, fail), std::runtime_error);
}

}  // namespace
}  // namespace scanway
