#pragma once

#include <algorithm>
#include <functional>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/hostile_bytes.h"

namespace scanway::test {

/// A decoder under hostile streams: what must hold for every protocol.
struct StreamTrial {
  std::function<FrameFinder()> make_finder;
  std::vector<Bytes> good;                       ///< Frames to damage.
  std::vector<Bytes> after;                      ///< Good frames that follow each hostile stream.
  int most_lost = 0;                             ///< Of those, where a stretch of noise passes for a frame.
  std::string_view beginnings;                   ///< The bytes that frames begin with.
  std::function<bool(const Bytes&)> is_frame;    ///< Said in other words than the decoder's.
  std::function<void(const Bytes&)> read_frame;  ///< May call a frame bad, in words; may not do anything else.
};

/// Reads a stream to its end: every byte is in exactly one stretch, every frame is a frame and stands in the stream.
/// Returns the frames.
inline std::vector<Bytes> read_stream(const StreamTrial& trial, const Bytes& stream, Random& random) {
  FrameFinder finder = trial.make_finder();
  std::vector<Bytes> frames;
  std::uint64_t covered = 0;
  const auto take = [&](const Stretch& stretch) {
    ASSERT_EQ(stretch.offset, covered);
    covered += stretch.length;
    if (!stretch.whole) return;
    ASSERT_TRUE(trial.is_frame(stretch.bytes));
    ASSERT_TRUE(std::equal(stretch.bytes.begin(), stretch.bytes.end(),
                           stream.begin() + static_cast<std::ptrdiff_t>(stretch.offset)));
    trial.read_frame(stretch.bytes);
    frames.push_back(stretch.bytes);
  };
  feed_in_pieces(finder, stream, random, take);
  finder.finish();
  while (const auto stretch = finder.next()) take(*stretch);
  EXPECT_EQ(covered, stream.size());
  return frames;
}

/// `count` streams of whole and damaged frames: no crash, and of the good frames after each no more are lost than
/// may be, the last never.
inline void try_hostile_streams(const StreamTrial& trial, int count, std::uint64_t seed) {
  Random random(seed);
  for (int i = 0; i < count; ++i) {
    Bytes stream = hostile_stream(trial.good, random);
    for (const Bytes& frame : trial.after) stream.insert(stream.end(), frame.begin(), frame.end());
    const auto frames = read_stream(trial, stream, random);
    const auto lost = std::count_if(trial.after.begin(), trial.after.end(), [&](const Bytes& frame) {
      return std::find(frames.begin(), frames.end(), frame) == frames.end();
    });
    ASSERT_LE(lost, trial.most_lost) << "stream " << i;
    ASSERT_EQ(frames.back(), trial.after.back()) << "stream " << i;
    ASSERT_FALSE(testing::Test::HasFatalFailure()) << "stream " << i;
  }
}

/// `count` streams of nothing but random bytes, with those that frames begin with more often than others.
inline void try_random_streams(const StreamTrial& trial, int count, std::uint64_t seed) {
  Random random(seed);
  for (int i = 0; i < count; ++i) {
    Bytes stream = random_bytes(1 + random.below(300), random);
    for (auto& byte : stream) {
      if (random.below(4) != 0) continue;
      byte = static_cast<std::uint8_t>(trial.beginnings[random.below(trial.beginnings.size())]);
    }
    read_stream(trial, stream, random);
    ASSERT_FALSE(testing::Test::HasFailure()) << "stream " << i;
  }
}

}  // namespace scanway::test
