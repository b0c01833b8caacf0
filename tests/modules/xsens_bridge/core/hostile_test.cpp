#include "tests/modules/xsens_bridge/hostile_xsens.h"

namespace scanway::test {

TEST(XsensStream, HostileStreamsNeverBreakTheDecoder) { try_hostile_streams(xsens_trial(), 20'000, 1); }

TEST(XsensStream, RandomStreamsNeverBreakTheDecoder) { try_random_streams(xsens_trial(), 20'000, 2); }

TEST(XsensStream, NoValueComesFromAMessageWithAWrongChecksum) {
  Random random(3);
  const std::vector<Bytes> good{small_mtdata2(1), small_mtdata2(2), small_mtdata2(3)};
  for (int i = 0; i < 20'000; ++i) {
    Bytes broken = good[1];
    broken[random.below(broken.size())] ^= static_cast<std::uint8_t>(1U << random.below(8));
    FrameFinder finder = xsens::make_frame_finder();
    for (const Bytes& frame : {good[0], broken, good[2]}) finder.push(frame);
    finder.finish();
    std::vector<Bytes> came;
    while (const auto stretch = finder.next()) {
      if (stretch->whole) came.push_back(stretch->bytes);
    }
    ASSERT_EQ(came, (std::vector<Bytes>{good[0], good[2]}));
  }
}

}  // namespace scanway::test
