#pragma once

#include <cstring>
#include <vector>

#include <gtest/gtest.h>

#include "modules/xsens_bridge/core/message.h"
#include "modules/xsens_bridge/core/mtdata.h"
#include "modules/xsens_bridge/core/mtdata2.h"
#include "modules/xsens_bridge/core/reading.h"
#include "modules/xsens_bridge/core/replies.h"
#include "tests/support/hostile_streams.h"

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

inline StreamTrial xsens_trial() {
  return {.make_finder = xsens::make_frame_finder,
          .good = good_xsens_frames(),
          .after = {small_mtdata2(1001), small_mtdata2(1002), small_mtdata2(1003)},
          .most_lost = 2,
          .beginnings = "\xFA\xFF\x36\x32\x04\x10\x20\xFA\xFF\x42",
          .is_frame = is_xsens_frame,
          .read_frame = read_whatever_it_is};
}

}  // namespace scanway::test
