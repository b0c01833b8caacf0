#include "tests/modules/sick_bridge/hostile_lms.h"

namespace scanway::test {

TEST(LmsStream, HostileStreamsNeverBreakTheDecoder) { try_hostile_streams(lms_trial(), 20'000, 1); }

TEST(LmsStream, RandomStreamsNeverBreakTheDecoder) { try_random_streams(lms_trial(), 20'000, 2); }

TEST(LmsStream, NoValueComesFromATelegramWithAWrongChecksum) {
  Random random(3);
  const std::vector<Bytes> good{small_scan(1), small_scan(2), small_scan(3)};
  int rejected = 0;
  for (int i = 0; i < 20'000; ++i) {
    Bytes broken = good[1];
    broken[random.below(broken.size())] ^= static_cast<std::uint8_t>(1U << random.below(8));
    FrameFinder finder = sick::make_frame_finder();
    for (const Bytes& frame : {good[0], broken, good[2]}) finder.push(frame);
    finder.finish();
    std::vector<Bytes> came;
    while (const auto stretch = finder.next()) {
      if (stretch->whole) came.push_back(stretch->bytes);
      rejected += stretch->whole ? 0 : 1;
    }
    ASSERT_EQ(came, (std::vector<Bytes>{good[0], good[2]}));
  }
  EXPECT_GE(rejected, 20'000);
}

TEST(LmsStream, ATelegramWhoseLengthIsTooLongDoesNotHoldUpThoseAfterIt) {
  Bytes broken = small_scan(1);
  broken[6] = 0x7F;  // 32 kB would have to come before its checksum could be looked at.
  FrameFinder finder = sick::make_frame_finder();
  finder.push(broken);
  finder.push(small_scan(2));
  EXPECT_FALSE(finder.next().has_value());
  finder.push(small_scan(3));
  const auto bad = finder.next(), two = finder.next(), three = finder.next();
  ASSERT_TRUE(bad && two && three);
  EXPECT_EQ(bad->length, broken.size());
  EXPECT_EQ(two->bytes, small_scan(2));
  EXPECT_EQ(three->bytes, small_scan(3));
}

}  // namespace scanway::test
