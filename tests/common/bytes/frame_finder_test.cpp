#include "common/bytes/frame_finder.h"

#include <gtest/gtest.h>

#include "common/bytes/big_endian.h"
#include "common/random/random.h"

namespace scanway {
namespace {

/// A toy protocol: '<', a digit that is the length, so many letters, '>'.
FrameProbe probe_toy(std::span<const std::uint8_t> bytes) {
  if (bytes[0] != '<') return FrameProbe::none();
  if (bytes.size() < 2) return FrameProbe::unfinished();
  if (bytes[1] < '0' || bytes[1] > '9') return FrameProbe::none();
  const std::size_t whole = 3U + bytes[1] - '0';
  if (bytes.size() < whole) return FrameProbe::unfinished();
  if (bytes[whole - 1] != '>') return FrameProbe::broken("no end");
  return FrameProbe::whole(whole);
}

std::string found_in(const std::string& stream, std::size_t piece, bool finish = true) {
  FrameFinder finder(probe_toy, '<');
  std::string found;
  const auto take = [&] {
    while (const auto stretch = finder.next()) {
      if (stretch->whole) {
        found.append(stretch->bytes.begin(), stretch->bytes.end());
      } else {
        found.append(1, '[').append(std::to_string(stretch->offset)).append(1, '+');
        found.append(std::to_string(stretch->length)).append(1, ']');
      }
    }
  };
  for (std::size_t at = 0; at < stream.size(); at += piece) {
    const std::string part = stream.substr(at, piece);
    finder.push(std::span(reinterpret_cast<const std::uint8_t*>(part.data()), part.size()));
    take();
  }
  if (finish) finder.finish();
  take();
  return found;
}

TEST(FrameFinder, FindsTheSameInPiecesOfEveryLength) {
  for (std::size_t piece = 1; piece < 20; ++piece) {
    EXPECT_EQ(found_in("xx<2ab><0>y<1a><3ab", piece), "[0+2]<2ab><0>[10+1]<1a>[15+4]");
    EXPECT_EQ(found_in("<2ab!<1a>", piece), "[0+5]<1a>");
    EXPECT_EQ(found_in("<<<1a>", piece), "[0+2]<1a>");
  }
}

TEST(FrameFinder, GivesUpAFrameInsideOfWhichTwoOthersFollowEachOther) {
  EXPECT_EQ(found_in("<9<1a>", 1, false), "");
  EXPECT_EQ(found_in("<9<1a><1b>", 1, false), "[0+2]<1a><1b>");
  EXPECT_EQ(found_in("<9<1a>x<1b", 1, false), "");
  for (std::size_t piece = 1; piece < 12; ++piece) EXPECT_EQ(found_in("<8<1a><1b>>", piece), "[0+2]<1a><1b>[10+1]");
}

TEST(FrameFinder, AFrameMayHoldWhatLooksLikeAnother) { EXPECT_EQ(found_in("<4<1a>>", 1), "<4<1a>>"); }

TEST(FrameFinder, BytesThatNeverFitAreOneStretch) {
  EXPECT_EQ(found_in(std::string(100, 'x'), 7), "[0+100]");
  EXPECT_EQ(found_in("", 1), "");
}

TEST(BigEndian, ReadsWhatWasWrittenAndNoFurther) {
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const std::uint64_t value = random.next();
    std::vector<std::uint8_t> bytes;
    append_big_endian(bytes, value, 8);
    append_big_endian(bytes, value, 4);
    append_big_endian(bytes, value, 2);
    append_big_endian(bytes, value, 1);
    BigEndianReader reader(bytes);
    EXPECT_EQ(reader.u64(), value);
    EXPECT_EQ(reader.u32(), static_cast<std::uint32_t>(value));
    EXPECT_EQ(reader.u16(), static_cast<std::uint16_t>(value));
    EXPECT_EQ(reader.u8(), static_cast<std::uint8_t>(value));
    EXPECT_THROW(reader.u8(), std::out_of_range);
  }
}

}  // namespace
}  // namespace scanway
