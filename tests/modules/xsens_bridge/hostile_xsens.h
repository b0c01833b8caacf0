#pragma once

#include <cstring>
#include <vector>

#include <gtest/gtest.h>

#include "modules/xsens_bridge/core/message.h"
#include "modules/xsens_bridge/core/mtdata.h"
#include "modules/xsens_bridge/core/mtdata2.h"
#include "modules/xsens_bridge/core/reading.h"
#include "modules/xsens_bridge/core/replies.h"
#include "tests/support/hostile_bytes.h"

namespace scanway::test {

/// A message with counter, quaternion and status.
inline Bytes small_mtdata2(std::uint16_t counter) {
  Bytes data{0x10, 0x20, 2, static_cast<std::uint8_t>(counter >> 8), static_cast<std::uint8_t>(counter)};
  const Bytes rest{0x20, 0x10, 16,   0x3F, 0x71, 0xCE, 0x6C, 0xBE, 0xA5, 0x6B, 0xCF, 0x3C, 0x61,
                   0x3B, 0xD8, 0xBD, 0x69, 0x1D, 0x25, 0xE0, 0x20, 4,    0,    0x40, 0,    3};
  data.insert(data.end(), rest.begin(), rest.end());
  return xsens::make_frame(xsens::kMtData2, data);
}

inline std::vector<Bytes> good_xsens_frames() {
  Bytes long_data;
  for (int i = 0; i < 60; ++i) long_data.insert(long_data.end(), {0x10, 0x20, 2, 0, static_cast<std::uint8_t>(i)});
  return {small_mtdata2(1),
          small_mtdata2(65535),
          xsens::make_frame(xsens::kMtData2, long_data),
          xsens::make_frame(xsens::kGoToConfig),
          xsens::set_number(xsens::kError, 4, 1),
          xsens::make_frame(xsens::kMtData, Bytes(18, 0x3F)),
          xsens::make_frame(xsens::kConfiguration, Bytes(118, 1)),
          xsens::set_output_configuration({{0x1020, 0xFFFF}, {0x2010, 100}})};
}

/// Whether the bytes are a frame, said in other words than the decoder's.
inline bool is_xsens_frame(const Bytes& frame) {
  if (frame.size() < 5 || frame[0] != 0xFA || frame[1] != 0xFF) return false;
  unsigned sum = 0;
  for (const auto byte : frame) sum += byte;
  if ((sum - 0xFA) % 256 != 0) return false;
  if (frame[3] != 0xFF) return frame.size() == frame[3] + 5U;
  return frame.size() == frame[4] * 256U + frame[5] + 7U && frame.size() >= 262;
}

inline void read_whatever_it_is(const Bytes& frame) {
  const xsens::Message message = xsens::open_frame(frame);
  try {
    if (message.mid == xsens::kMtData2) xsens::make_reading(xsens::parse_mtdata2(message.data));
    if (message.mid == xsens::kMtData) {
      const auto layout = xsens::guess_layout(message.data);
      if (layout) xsens::make_reading(xsens::parse_mtdata(message.data, *layout));
    }
    if (message.mid == xsens::kConfiguration) xsens::parse_configuration(message);
    if (message.mid == xsens::kSetOutputConfiguration) xsens::parse_output_configuration(message);
    if (message.mid == xsens::kError) xsens::parse_error(message);
  } catch (const xsens::BadMessage& error) {
    EXPECT_GT(std::strlen(error.what()), 0U);
  }
}

/// `count` hostile streams: no crash, every byte in exactly one stretch, every frame a frame, and after each stream at
/// most two good messages until messages come through again.
inline void try_hostile_xsens_streams(int count, std::uint64_t seed) {
  Random random(seed);
  const auto good = good_xsens_frames();
  const std::vector<Bytes> after{small_mtdata2(1001), small_mtdata2(1002), small_mtdata2(1003)};
  for (int i = 0; i < count; ++i) {
    Bytes stream = hostile_stream(good, random);
    for (const Bytes& frame : after) stream.insert(stream.end(), frame.begin(), frame.end());
    FrameFinder finder = xsens::make_frame_finder();
    std::uint64_t covered = 0;
    bool third_came = false;
    const auto take = [&](const Stretch& stretch) {
      ASSERT_EQ(stretch.offset, covered);
      covered += stretch.length;
      if (!stretch.whole) return;
      ASSERT_TRUE(is_xsens_frame(stretch.bytes));
      read_whatever_it_is(stretch.bytes);
      third_came = third_came || stretch.bytes == after[2];
    };
    feed_in_pieces(finder, stream, random, take);
    ASSERT_TRUE(third_came) << "stream " << i;
    finder.finish();
    while (const auto stretch = finder.next()) take(*stretch);
    ASSERT_EQ(covered, stream.size()) << "stream " << i;
  }
}

/// `count` streams of nothing but random bytes, with the bytes that frames begin with more often than others.
inline void try_random_xsens_streams(int count, std::uint64_t seed) {
  Random random(seed);
  for (int i = 0; i < count; ++i) {
    Bytes stream = random_bytes(1 + random.below(300), random);
    for (auto& byte : stream) {
      if (random.below(4) == 0)
        byte = static_cast<std::uint8_t>("\xFA\xFF\x36\x32\x04\x10\x20\xFA\xFF\x42"[random.below(10)]);
    }
    FrameFinder finder = xsens::make_frame_finder();
    std::uint64_t covered = 0;
    const auto take = [&](const Stretch& stretch) {
      covered += stretch.length;
      if (stretch.whole) read_whatever_it_is(stretch.bytes);
    };
    feed_in_pieces(finder, stream, random, take);
    finder.finish();
    while (const auto stretch = finder.next()) take(*stretch);
    ASSERT_EQ(covered, stream.size()) << "stream " << i;
  }
}

}  // namespace scanway::test
