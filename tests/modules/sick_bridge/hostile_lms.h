#pragma once

#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "common/bytes/big_endian.h"
#include "modules/sick_bridge/core/commands.h"
#include "modules/sick_bridge/core/describe.h"
#include "modules/sick_bridge/core/scan.h"
#include "tests/support/hostile_streams.h"

namespace scanway::test {

inline Bytes bytes_of(const std::string& text) { return {text.begin(), text.end()}; }

/// A scan of few beams in the binary dialect, written by hand from the field table.
inline Bytes small_scan(std::uint16_t counter) {
  std::string body = "sSN LMDscandata ";
  const auto put = [&](std::uint64_t value, int size) { append_big_endian(body, value, size); };
  put(0, 2), put(1, 2), put(18110550, 4), put(0, 2), put(counter, 2), put(counter, 2);
  put(1000000U + 40000U * counter, 4), put(1041000U + 40000U * counter, 4), put(0, 2), put(0x3F00, 2), put(0, 2);
  put(2500, 4), put(540, 4), put(0, 2), put(1, 2);
  body += "DIST1";
  put(0x3F800000, 4), put(0, 4), put(0xFFFF3CB0, 4), put(1667, 2), put(3, 2);
  put(1303, 2), put(counter, 2), put(628, 2);
  for (int flag = 0; flag < 6; ++flag) put(0, 2);
  return bytes_of(sick::make_frame(sick::Dialect::cola_b, body));
}

inline std::vector<Bytes> good_lms_frames() {
  using sick::Dialect;
  std::vector<Bytes> frames{small_scan(7), small_scan(8)};
  for (const Dialect dialect : {Dialect::cola_b, Dialect::cola_a}) {
    frames.push_back(bytes_of(set_scan_config(dialect, {}).frame));
    frames.push_back(bytes_of(set_scan_content(dialect, {}).frame));
    frames.push_back(bytes_of(sick::log_in(dialect).frame));
  }
  frames.push_back(bytes_of(sick::make_frame(Dialect::cola_b, std::string("sFA\0\3", 5))));
  frames.push_back(bytes_of(sick::make_frame(
      Dialect::cola_a,
      "sSN LMDscandata 0 1 1145856 0 0 A C F4240 FE268 0 0 3F 0 0 9C4 21C 0 1 DIST1 3F800000 00000000 0 2710 2 1F4 "
      "258 0 0 0 0 0 1 FDIN 7B F4434 6DDD0")));
  return frames;
}

/// Whether the bytes are a frame, said in other words than the decoder's.
inline bool is_lms_frame(const Bytes& frame) {
  if (frame.size() < 5 || frame.front() != 2) return false;
  if (frame[1] != 2) return frame.back() == 3;
  const std::size_t length = frame.size() - 9;
  std::uint8_t sum = 0;
  for (std::size_t i = 8; i < frame.size(); ++i) sum ^= frame[i];  // The checksum cancels itself.
  return sum == 0 && frame[6] * 256U + frame[7] == length && frame[4] == 0 && frame[5] == 0;
}

inline void read_whatever_it_is(const Bytes& frame) {
  try {
    const sick::Telegram telegram = sick::open_frame(frame);
    if (is_scan(telegram)) {
      parse_scan(telegram);
    } else {
      describe(telegram);
    }
  } catch (const sick::BadTelegram& error) {
    EXPECT_GT(std::strlen(error.what()), 0U);
  }
}

inline StreamTrial lms_trial() {
  using namespace std::string_view_literals;
  return {.make_finder = sick::make_frame_finder,
          .good = good_lms_frames(),
          .after = {small_scan(1001), small_scan(1002), small_scan(1003)},
          .most_lost = 1,
          .beginnings = "\x02\x02\x03sSNRA \x00"sv,
          .is_frame = is_lms_frame,
          .read_frame = read_whatever_it_is};
}

}  // namespace scanway::test
