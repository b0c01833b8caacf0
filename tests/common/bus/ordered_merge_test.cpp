#include "common/bus/ordered_merge.h"

#include <algorithm>
#include <limits>
#include <string>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "common/random/random.h"

namespace scanway {
namespace {

using Left = std::vector<std::tuple<Utime, std::size_t, int>>;  // Time, channel, item: as it left.

struct Datum {
  std::size_t channel;
  Utime utime;
  int item;
};

OrderedMerge<int> merge_into(Left& left, std::vector<MergedChannel> channels) {
  return OrderedMerge<int>(std::move(channels), [&left](std::size_t channel, Utime utime, int&& item) {
    left.emplace_back(utime, channel, item);
  });
}

TEST(OrderedMerge, WaitsForEveryChannel) {
  Left left;
  auto merge = merge_into(left, {{"A", 100, true}, {"B", 100, true}});
  merge.add(0, 10, 1);
  merge.add(0, 20, 2);
  EXPECT_TRUE(left.empty());
  merge.add(1, 20, 3);  // A's item of 20 goes first, and A may have another one of 20: B's waits.
  EXPECT_EQ(left, (Left{{10, 0, 1}, {20, 0, 2}}));
  merge.add(0, 21, 4);
  EXPECT_EQ(left.back(), (std::tuple<Utime, std::size_t, int>{20, 1, 3}));
  EXPECT_EQ(merge.waiting(), 1U);
  merge.flush();
  EXPECT_EQ(left.size(), 4U);
}

TEST(OrderedMerge, WaitsForASilentChannelAsLongAsItsBound) {
  Left left;
  auto merge = merge_into(left, {{"A", 100, true}, {"B", 50, true}});
  merge.add(0, 10, 1);
  merge.add(0, 60, 2);
  EXPECT_TRUE(left.empty());
  merge.add(0, 61, 3);
  EXPECT_EQ(left, (Left{{10, 0, 1}}));
  EXPECT_FALSE(merge.add(1, 9, 4));
  EXPECT_TRUE(merge.add(1, 10, 5));  // Of the same time, and B goes after A.
  EXPECT_EQ(merge.late(0), 0U);
  EXPECT_EQ(merge.late(1), 1U);
  EXPECT_EQ(merge.last_late()->channel, "B");
  EXPECT_EQ(merge.last_late()->utime, 9);
  EXPECT_EQ(left, (Left{{10, 0, 1}, {10, 1, 5}}));
}

TEST(OrderedMerge, TakesTheExtremesOfTime) {
  Left left;
  auto merge = merge_into(left, {{"A", 0, true}, {"B", std::numeric_limits<Utime>::max(), true}});
  merge.add(0, std::numeric_limits<Utime>::max(), 1);
  merge.add(0, std::numeric_limits<Utime>::min(), 2);
  EXPECT_EQ(left.size(), 1U);  // The difference of the two is more than B's bound.
  merge.flush();
  EXPECT_EQ(left.size(), 2U);
  EXPECT_FALSE(merge.add(1, 0, 3));
}

/// Data of a few channels, close enough in time that many are equal.
std::vector<Datum> random_data(Random& random, std::size_t channels) {
  std::vector<Datum> data;
  for (std::size_t channel = 0; channel < channels; ++channel) {
    const std::uint64_t n = random.below(30);
    Utime utime = 0;
    for (std::uint64_t i = 0; i < n; ++i) {
      utime += 1 + static_cast<Utime>(random.below(8));
      data.push_back({channel, utime, static_cast<int>(data.size())});
    }
  }
  return data;
}

/// A random order of arrival that keeps every channel's bound and, where it says so, its order.
std::vector<Datum> random_arrival(Random& random, std::vector<Datum> data, const std::vector<MergedChannel>& channels) {
  std::vector<Datum> arrived;
  while (!data.empty()) {
    const auto may_come = [&](const Datum& candidate) {
      return std::none_of(data.begin(), data.end(), [&](const Datum& other) {
        const MergedChannel& of_other = channels[other.channel];
        const bool must_precede = candidate.utime > other.utime + of_other.bound_us;
        const bool own_order = of_other.in_order && other.channel == candidate.channel && other.utime < candidate.utime;
        return must_precede || own_order;
      });
    };
    std::size_t pick = random.below(data.size());
    while (!may_come(data[pick])) pick = (pick + 1) % data.size();
    arrived.push_back(data[pick]);
    data.erase(data.begin() + static_cast<std::ptrdiff_t>(pick));
  }
  return arrived;
}

TEST(OrderedMerge, GivesTheSameForEveryArrivalThatKeepsTheBounds) {
  Random random(7);
  for (int round = 0; round < 300; ++round) {
    std::vector<MergedChannel> channels;
    const std::size_t n = 1 + random.below(4);
    for (std::size_t i = 0; i < n; ++i) {
      channels.push_back({std::to_string(i), static_cast<Utime>(random.below(60)), random.below(2) == 0});
    }
    const auto data = random_data(random, n);
    Left expected;
    for (const Datum& datum : data) expected.emplace_back(datum.utime, datum.channel, datum.item);
    std::sort(expected.begin(), expected.end());
    for (int order = 0; order < 5; ++order) {
      Left left;
      auto merge = merge_into(left, channels);
      for (const Datum& datum : random_arrival(random, data, channels)) {
        ASSERT_TRUE(merge.add(datum.channel, datum.utime, datum.item));
      }
      merge.flush();
      ASSERT_EQ(left, expected);
    }
  }
}

TEST(OrderedMerge, NeverDeliversOutOfOrderAndCountsWhatItDrops) {
  Random random(8);
  for (int round = 0; round < 300; ++round) {
    Left left;
    auto merge = merge_into(left, {{"A", 3, true}, {"B", 0, false}, {"C", 20, true}});
    std::uint64_t taken = 0;
    for (int i = 0; i < 200; ++i) taken += merge.add(random.below(3), static_cast<Utime>(random.below(100)), i) ? 1 : 0;
    merge.flush();
    EXPECT_EQ(left.size(), taken);
    EXPECT_EQ(taken + merge.late(0) + merge.late(1) + merge.late(2), 200U);
    for (std::size_t i = 1; i < left.size(); ++i) {
      ASSERT_LE(std::tuple(std::get<0>(left[i - 1]), std::get<1>(left[i - 1])),
                std::tuple(std::get<0>(left[i]), std::get<1>(left[i])));
    }
  }
}

}  // namespace
}  // namespace scanway
