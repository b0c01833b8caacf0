// Against the C library's long double versions, which have 11 bits more.
#include "common/math/repeatable.h"

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "common/math/angle.h"
#include "common/random/random.h"

namespace scanway {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kDraws = 300000;

/// |value - truth| in units in the last place of the truth.
double ulps(double value, long double truth) {
  const auto near = static_cast<double>(std::fabs(truth));
  const double ulp = std::nextafter(near, kInfinity) - near;
  return static_cast<double>(std::fabs(value - truth)) / ulp;
}

/// A number of random sign and of any size between 10^low and 10^high.
double any_size(Random& random, double low, double high) {
  const double size = std::pow(10.0, low + (high - low) * random.uniform());
  return random.below(2) == 0 ? size : -size;
}

TEST(Repeatable, SineAndCosine) {
  Random random(1);
  const auto check = [](double x) {
    // Near a zero the reduction's absolute error counts.
    const long double sine = std::sin(static_cast<long double>(x)), cosine = std::cos(static_cast<long double>(x));
    const double s = repeatable::sin(x), c = repeatable::cos(x);
    ASSERT_TRUE(ulps(s, sine) < 2 || std::fabs(s - sine) < 1e-15L) << x;
    ASSERT_TRUE(ulps(c, cosine) < 2 || std::fabs(c - cosine) < 1e-15L) << x;
  };
  for (int i = 0; i < kDraws; ++i) check(any_size(random, -10, 5));
  for (int k = -2000; k <= 2000; ++k) {
    for (const double off : {0.0, 1e-9, -1e-9, 1e-16}) check(k * M_PI / 4 + off);
  }
  EXPECT_EQ(repeatable::sin(0.0), 0.0);
  EXPECT_EQ(repeatable::cos(0.0), 1.0);
}

TEST(Repeatable, ArcTangent) {
  Random random(2);
  for (int i = 0; i < kDraws; ++i) {
    const double y = any_size(random, -8, 8), x = any_size(random, -8, 8);
    ASSERT_LT(ulps(repeatable::atan2(y, x), std::atan2(static_cast<long double>(y), static_cast<long double>(x))), 2)
        << y << " " << x;
  }
  EXPECT_EQ(repeatable::atan2(0, 0), 0);
  EXPECT_EQ(repeatable::atan2(0, 1), 0);
  EXPECT_EQ(repeatable::atan2(0, -1), repeatable::kPi);
  EXPECT_EQ(repeatable::atan2(1, 0), repeatable::kPi / 2);
  EXPECT_EQ(repeatable::atan2(-1, 0), -repeatable::kPi / 2);
  EXPECT_TRUE(std::isnan(repeatable::atan2(NAN, 1)));
}

TEST(Repeatable, Exponential) {
  Random random(3);
  for (int i = 0; i < kDraws; ++i) {
    const double x = any_size(random, -12, 2.84);
    ASSERT_LT(ulps(repeatable::exp(x), std::exp(static_cast<long double>(x))), 2) << x;
  }
  EXPECT_EQ(repeatable::exp(0), 1);
  EXPECT_EQ(repeatable::exp(1000), kInfinity);
  EXPECT_EQ(repeatable::exp(-1000), 0);
  EXPECT_EQ(repeatable::exp(-kInfinity), 0);
  EXPECT_EQ(repeatable::exp(kInfinity), kInfinity);
  EXPECT_TRUE(std::isnan(repeatable::exp(NAN)));
  EXPECT_NEAR(repeatable::exp(-740) / std::exp(-740), 1, 1e-3);
}

TEST(Repeatable, Logarithm) {
  Random random(4);
  for (int i = 0; i < kDraws; ++i) {
    const double x = std::fabs(any_size(random, -300, 300));
    ASSERT_LT(ulps(repeatable::log(x), std::log(static_cast<long double>(x))), 2) << x;
    const double near_one = 1 + any_size(random, -15, -0.5);
    ASSERT_LT(ulps(repeatable::log(near_one), std::log(static_cast<long double>(near_one))), 2) << near_one;
  }
  EXPECT_EQ(repeatable::log(1), 0);
  EXPECT_EQ(repeatable::log(0), -kInfinity);
  EXPECT_EQ(repeatable::log(kInfinity), kInfinity);
  EXPECT_TRUE(std::isnan(repeatable::log(-1)));
  const double tiny = std::numeric_limits<double>::denorm_min();
  EXPECT_LT(ulps(repeatable::log(tiny), std::log(static_cast<long double>(tiny))), 2);
}

TEST(Angle, DegreesAreRoundedOnce) {
  EXPECT_EQ(radians(180), repeatable::kPi);
  EXPECT_EQ(radians(90), repeatable::kPi / 2);
  EXPECT_EQ(radians(0), 0.0);
  for (int degrees = -720; degrees <= 720; ++degrees) {
    EXPECT_LE(ulps(radians(degrees), degrees * 3.14159265358979323846264338327950288L / 180), 0.5001);
  }
}

}  // namespace
}  // namespace scanway
