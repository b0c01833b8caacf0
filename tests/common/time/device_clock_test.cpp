#include "common/time/device_clock.h"

#include <gtest/gtest.h>

#include <cmath>

#include "common/random/random.h"

namespace scanway {
namespace {

constexpr Utime kSecond = kMicrosecondsPerSecond;
constexpr Utime kStart = 1'700'000'000 * kSecond;
constexpr std::int64_t kWrap = std::int64_t{1} << 32;

/// A device whose clock runs fast by `drift` and began at `offset`, heard of 0.3 ms later at least and often much more.
struct Device {
  double drift = 0.0;
  std::int64_t offset = 0;
  Random random{1};

  std::int64_t ticks_at(Utime host) const {
    const auto elapsed = static_cast<std::int64_t>(static_cast<double>(host - kStart) * (1.0 + drift));
    return (elapsed + offset) % kWrap;
  }
  Utime delay() { return 300 + static_cast<Utime>(2000.0 * std::pow(random.uniform(), 3.0)); }
};

/// Feeds `seconds` of scans at 25 Hz; returns the largest error of the mapped times after the first second.
Utime largest_error(DeviceClock& clock, Device& device, Utime from, int seconds) {
  Utime largest = 0;
  for (Utime host = from; host < from + seconds * kSecond; host += kSecond / 25) {
    clock.observe(device.ticks_at(host), host + device.delay());
    const Utime error = clock.to_host(device.ticks_at(host)).value() - host;
    if (host > from + kSecond) largest = std::max(largest, std::abs(error));
  }
  return largest;
}

TEST(DeviceClock, FollowsDriftWithinAMillisecondAndAHalf) {
  for (const double drift : {-50e-6, 0.0, 50e-6}) {
    DeviceClock clock;
    Device device{drift, 12345, Random(2)};
    EXPECT_LT(largest_error(clock, device, kStart, 200), 1500);
    EXPECT_EQ(clock.jumps(), 0);
  }
}

TEST(DeviceClock, GoesOnOverTheWrap) {
  DeviceClock clock;
  Device device{20e-6, kWrap - 30 * kSecond, Random(3)};
  EXPECT_LT(largest_error(clock, device, kStart, 60), 1500);
  EXPECT_EQ(clock.jumps(), 0);
  // A time from before the wrap can still be asked for.
  EXPECT_NEAR(static_cast<double>(*clock.to_host(device.ticks_at(kStart + 20 * kSecond)) - kStart), 20e6, 3000.0);
}

TEST(DeviceClock, ASilenceLongerThanTheWrapIsNoJump) {
  DeviceClock clock;
  Device device{20e-6, 0, Random(4)};
  largest_error(clock, device, kStart, 20);
  EXPECT_LT(largest_error(clock, device, kStart + 3 * 4295 * kSecond, 20), 1500);
  EXPECT_EQ(clock.jumps(), 0);
}

TEST(DeviceClock, ADeviceThatStartedAnewIsAJump) {
  DeviceClock clock;
  Device device{0.0, 1'000'000'000, Random(5)};
  largest_error(clock, device, kStart, 20);
  device.offset = -20 * kSecond;
  EXPECT_LT(largest_error(clock, device, kStart + 20 * kSecond, 20), 1500);
  EXPECT_EQ(clock.jumps(), 1);
}

TEST(DeviceClock, AHostClockThatWasSetIsForgottenInTwentySeconds) {
  DeviceClock clock;
  for (Utime t = 0; t < 60 * kSecond; t += kSecond / 25) {
    const Utime set_forward = t > 20 * kSecond ? kSecond : 0;
    clock.observe(t, kStart + t + set_forward);
  }
  EXPECT_EQ(*clock.to_host(59 * kSecond), kStart + 60 * kSecond);
}

TEST(DeviceClock, OlderTimesChangeNothing) {
  DeviceClock clock({100, kWrap});
  clock.observe(1'000'000, kStart);
  clock.observe(1'000'100, kStart + 10'000);
  const Utime before = *clock.to_host(1'000'100);
  clock.observe(999'650, kStart + 12'000);  // A fix of GNSS, 45 ms old.
  EXPECT_EQ(*clock.to_host(1'000'100), before);
}

TEST(DeviceClock, SaysNothingBeforeItKnows) {
  DeviceClock clock;
  EXPECT_FALSE(clock.to_host(5).has_value());
  clock.observe(5, kStart);
  EXPECT_EQ(clock.to_host(5), kStart);
  clock.restart();
  EXPECT_FALSE(clock.to_host(5).has_value());
}

}  // namespace
}  // namespace scanway
