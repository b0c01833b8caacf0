// What is missing in streams without numbers.
#include "common/delivery/spacing.h"

#include <gtest/gtest.h>

#include <limits>

#include "common/random/random.h"

namespace scanway {
namespace {

constexpr Utime kInterval = 10'000;  // 100 Hz
constexpr Utime kFirst = 1'700'000'000 * kMicrosecondsPerSecond;

TEST(Spacing, CountsWhatALinkLosesOfAnEvenStream) {
  for (const double loss : {0.0, 0.01, 0.05, 0.1}) {
    Random random(3);
    Spacing spacing;
    std::int64_t lost = 0, lost_since = 0;
    for (int i = 0; i < 20'000; ++i) {
      const bool is_lost = i > 100 && random.uniform() < loss;
      lost_since += is_lost ? 1 : 0;
      if (is_lost) continue;
      lost += lost_since;  // The next one shows it.
      lost_since = 0;
      const auto jitter = static_cast<Utime>(random.below(kInterval / 5)) - kInterval / 10;
      spacing.add(kFirst + i * kInterval + jitter);
    }
    EXPECT_EQ(spacing.missing(), lost) << loss;
  }
}

TEST(Spacing, SaysNothingOfAnUnevenStream) {
  Random random(4);
  Spacing spacing;
  Utime utime = kFirst;
  for (int i = 0; i < 1000; ++i) spacing.add(utime += 1 + static_cast<Utime>(random.below(5'000'000)));
  EXPECT_EQ(spacing.missing(), 0);
}

TEST(Spacing, SaysNothingOfRepeatsDisorderPausesAndAbsurdTimes) {
  Spacing spacing;
  for (int i = 0; i < 100; ++i) {
    spacing.add(kFirst + i * kInterval);
    spacing.add(kFirst + i * kInterval);
    spacing.add(kFirst + (i - 5) * kInterval);
  }
  spacing.add(kFirst + 3600 * kMicrosecondsPerSecond);  // Switched off and on.
  EXPECT_EQ(spacing.missing(), 0);
  spacing.add(std::numeric_limits<Utime>::max());
  spacing.add(std::numeric_limits<Utime>::min());
  EXPECT_EQ(spacing.missing(), 0);
  Spacing from_the_end_of_time;
  from_the_end_of_time.add(std::numeric_limits<Utime>::min());
  from_the_end_of_time.add(std::numeric_limits<Utime>::max());
  EXPECT_EQ(from_the_end_of_time.missing(), 0);
}

}  // namespace
}  // namespace scanway
