#include "common/random/random.h"

#include <array>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace scanway {
namespace {

TEST(Random, IsSplitMix64) {
  // Published with xoshiro (Vigna, splitmix64.c): seed 1234567.
  Random random(1234567);
  for (const std::uint64_t expected : {6457827717110365317u, 3203168211198807973u, 9817491932198370423u,
                                       4593380528125082431u, 16408922859458223821u}) {
    EXPECT_EQ(random.next(), expected);
  }
  EXPECT_EQ(Random(0).next(), 0xE220A8397B1DCDAFu);
}

TEST(Random, UniformHasItsMoments) {
  Random random(5);
  double sum = 0, squares = 0;
  constexpr int kDraws = 1000000;
  for (int i = 0; i < kDraws; ++i) {
    const double u = random.uniform();
    ASSERT_GE(u, 0.0);
    ASSERT_LT(u, 1.0);
    sum += u;
    squares += u * u;
  }
  // Five standard errors.
  EXPECT_NEAR(sum / kDraws, 0.5, 5 * std::sqrt(1.0 / 12 / kDraws));
  EXPECT_NEAR(squares / kDraws, 1.0 / 3, 5 * std::sqrt(4.0 / 45 / kDraws));
}

TEST(Random, NormalHasItsMomentsAndTails) {
  Random random(6);
  constexpr int kDraws = 1000000;
  std::array<double, 5> moments{};
  int beyond_two = 0;
  for (int i = 0; i < kDraws; ++i) {
    const double z = random.normal();
    ASSERT_TRUE(std::isfinite(z));
    double power = 1;
    for (double& moment : moments) moment += power, power *= z;
    beyond_two += std::fabs(z) > 2;
  }
  for (double& moment : moments) moment /= kDraws;
  EXPECT_NEAR(moments[1], 0, 5 * std::sqrt(1.0 / kDraws));
  EXPECT_NEAR(moments[2], 1, 5 * std::sqrt(2.0 / kDraws));
  EXPECT_NEAR(moments[3], 0, 5 * std::sqrt(15.0 / kDraws));
  EXPECT_NEAR(moments[4], 3, 5 * std::sqrt(96.0 / kDraws));
  EXPECT_NEAR(static_cast<double>(beyond_two) / kDraws, std::erfc(std::sqrt(2.0)), 0.0011);
}

TEST(Random, BelowIsEven) {
  Random random(7);
  std::array<int, 7> counts{};
  constexpr int kDraws = 700000;
  for (int i = 0; i < kDraws; ++i) ++counts[random.below(7)];
  double chi_square = 0;
  for (const int count : counts) chi_square += (count - kDraws / 7.0) * (count - kDraws / 7.0) / (kDraws / 7.0);
  EXPECT_LT(chi_square, 27.9);  // six degrees of freedom, one in ten thousand
  EXPECT_EQ(random.below(1), 0u);
  for (int i = 0; i < 1000; ++i)
    EXPECT_LT(random.below(3 * (std::numeric_limits<std::uint64_t>::max() / 4)),
              3 * (std::numeric_limits<std::uint64_t>::max() / 4));
}

}  // namespace
}  // namespace scanway
