#include "modules/sick_bridge/node/line_archive.h"

#include <gtest/gtest.h>

#include <limits>

#include "common/random/random.h"

namespace scanway::test {
namespace {

using Message = sick::LineArchive::Message;

constexpr SteadyTime kSecond = 1'000'000;
constexpr SteadyTime kPeriod = kSecond / 25;

/// Four messages that no other line has.
std::vector<Message> line(std::int64_t number) {
  Random random(static_cast<std::uint64_t>(number));
  std::vector<Message> messages(4);
  for (Message& message : messages) {
    for (int i = 0; i < 1200; ++i) message.push_back(static_cast<std::uint8_t>(random.below(256)));
  }
  return messages;
}

class Archive : public testing::Test {
 protected:
  void keep(std::int64_t lines) {
    for (std::int64_t i = 0; i < lines; ++i, ++next_, now_ += kPeriod) archive_.keep(line(next_), now_);
  }
  /// What it sends in `time`, and how long it took until the last.
  std::vector<Message> sent(SteadyTime time) {
    std::vector<Message> all;
    for (const SteadyTime end = now_ + time; now_ < end; now_ += 10'000) {
      archive_.pump(now_, [&](const Message& message) { all.push_back(message), last_ = now_; });
    }
    return all;
  }

  sick::LineArchive archive_;
  std::int64_t next_ = 0;
  SteadyTime now_ = kSecond, last_ = 0;
};

TEST_F(Archive, SendsTheSameBytesAgain) {
  keep(100);
  EXPECT_TRUE(sent(kSecond).empty());
  archive_.ask(7, 9, now_);
  archive_.ask(3, 4, now_);
  std::vector<Message> expected;
  for (const std::int64_t number : {3, 7, 8}) {
    for (const Message& message : line(number)) expected.push_back(message);
  }
  EXPECT_EQ(sent(kSecond), expected);
  EXPECT_EQ(archive_.counters().lines_resent, 3);
}

TEST_F(Archive, KeepsAMinuteAndRefusesWhatIsOlder) {
  keep(40 * 60);
  const std::int64_t oldest = next_ - 25 * 60;
  archive_.ask(oldest - 20, oldest + 3, now_);
  EXPECT_EQ(sent(kSecond).size(), 3U * 4U);
  EXPECT_EQ(archive_.counters().lines_too_old, 20);
  EXPECT_EQ(archive_.counters().lines_resent, 3);
  now_ += 61 * kSecond;
  archive_.ask(0, next_, now_);
  EXPECT_TRUE(sent(kSecond).empty());
  EXPECT_EQ(archive_.bytes(), 0U);
  EXPECT_EQ(archive_.counters().lines_too_old, 20 + next_);
}

TEST_F(Archive, SendsNoFasterThanItMay) {
  keep(25 * 50);
  const SteadyTime began = now_;
  archive_.ask(0, next_, now_);
  const auto messages = sent(30 * kSecond);
  const double bytes = 1200.0 * static_cast<double>(messages.size());
  const double seconds = static_cast<double>(last_ - began) / kSecond;
  EXPECT_LE(bytes, 500e3 * seconds + 20e3 + 4800);
  EXPECT_GE(bytes, 0.95 * 500e3 * seconds);
  // While they waited, the oldest became too old: everything is accounted for.
  EXPECT_EQ(archive_.counters().lines_resent + archive_.counters().lines_too_old, next_);
}

TEST_F(Archive, ALineThatSeveralAskForGoesOnce) {
  keep(10);
  for (int i = 0; i < 50; ++i) archive_.ask(5, 6, now_);
  EXPECT_EQ(sent(10'000).size(), 4U);
  archive_.ask(5, 6, now_);
  EXPECT_TRUE(sent(50'000).empty());
  now_ += 100'000;  // Whoever asks now has waited for it.
  archive_.ask(5, 6, now_);
  EXPECT_EQ(sent(10'000).size(), 4U);
}

TEST_F(Archive, LiesCostNothing) {
  constexpr std::int64_t kMost = std::numeric_limits<std::int64_t>::max();
  keep(10);
  for (int i = 0; i < 1000; ++i) archive_.ask(-kMost, kMost, now_);
  archive_.ask(kMost - 1, kMost, now_);
  archive_.ask(kMost, -kMost, now_);
  archive_.ask(5, 5, now_);
  EXPECT_EQ(archive_.waiting(), 10U);
  EXPECT_GT(archive_.counters().lines_unknown, 0);
  EXPECT_EQ(sent(kSecond).size(), 40U);
}

TEST_F(Archive, MemoryIsBounded) {
  sick::ArchiveLimits limits;
  limits.bytes = 100'000;
  sick::LineArchive small(limits);
  for (int i = 0; i < 100; ++i) small.keep(line(i), now_);
  EXPECT_LE(small.bytes(), 100'000U);
  EXPECT_GE(small.bytes(), 90'000U);
  small.ask(0, 100, now_);
  EXPECT_EQ(small.counters().lines_too_old, 100 - 20);
}

}  // namespace
}  // namespace scanway::test
