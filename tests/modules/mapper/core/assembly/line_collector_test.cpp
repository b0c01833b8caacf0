#include "modules/mapper/core/assembly/line_collector.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "common/random/random.h"

namespace scanway {
namespace {

LinePiece piece_of(std::int64_t number, int first, int count, int of = 100) {
  LinePiece piece;
  piece.line.number = number;
  piece.line.utime = 1'000'000 + 40'000 * number;
  piece.numbered_since = 5;
  piece.beams_of_line = of;
  piece.first_beam = first;
  for (int beam = first; beam < first + count; ++beam) {
    piece.line.range_counts.push_back(static_cast<std::uint16_t>(100 + number + beam));
    piece.line.rssi_counts.push_back(static_cast<std::uint16_t>(beam));
  }
  return piece;
}

TEST(LineCollector, PiecesInAnyOrderAndTwiceGiveTheLines) {
  std::vector<LinePiece> pieces;
  for (int number = 0; number < 20; ++number) {
    for (const int first : {0, 30, 60}) pieces.push_back(piece_of(number, first, first == 60 ? 40 : 30));
  }
  const std::vector<LinePiece> again(pieces.begin(), pieces.begin() + 10);
  pieces.insert(pieces.end(), again.begin(), again.end());
  Random random(1);
  for (std::size_t i = pieces.size(); i > 1; --i) std::swap(pieces[i - 1], pieces[random.below(i)]);
  LineCollector collector;
  for (const LinePiece& piece : pieces) EXPECT_TRUE(collector.add(piece));
  EXPECT_EQ(collector.repeated_pieces(), 10U);
  EXPECT_TRUE(collector.missing().empty());
  const std::vector<ScanLine> lines = collector.take();
  ASSERT_EQ(lines.size(), 20U);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    EXPECT_EQ(lines[i].number, static_cast<std::int64_t>(i));
    EXPECT_EQ(lines[i].missing_beams, 0);
    for (std::size_t beam = 0; beam < 100; ++beam) EXPECT_EQ(lines[i].range_counts[beam], 100 + i + beam);
  }
  EXPECT_EQ(collector.lines(), 0U);
}

TEST(LineCollector, SaysWhatIsMissing) {
  LineCollector collector;
  for (const int number : {3, 4, 8, 9, 10}) collector.add(piece_of(number, 0, number == 9 ? 70 : 100));
  const std::vector<std::pair<std::int64_t, std::int64_t>> expected = {{5, 7}, {9, 9}};
  EXPECT_EQ(collector.missing(), expected);
  collector.add(piece_of(9, 70, 30));
  collector.add(piece_of(6, 0, 100));
  const std::vector<std::pair<std::int64_t, std::int64_t>> then = {{5, 5}, {7, 7}};
  EXPECT_EQ(collector.missing(), then);
  EXPECT_EQ(collector.take_before(1'000'000 + 40'000 * 8).size(), 3U);
  EXPECT_EQ(collector.lines(), 3U);
}

TEST(LineCollector, RefusesWhatContradictsItself) {
  LineCollector collector;
  LinePiece piece = piece_of(1, 0, 50);
  EXPECT_TRUE(collector.add(piece));
  piece.first_beam = 60;  // Ends after the line does.
  EXPECT_FALSE(collector.add(piece));
  piece.first_beam = -1;
  EXPECT_FALSE(collector.add(piece));
  EXPECT_FALSE(collector.add(piece_of(1, 50, 50, 120))) << "the line has 100 beams";
  piece = piece_of(1, 50, 50);
  piece.line.rssi_counts.pop_back();
  EXPECT_FALSE(collector.add(piece));
  piece = piece_of(2, 0, 1);
  piece.beams_of_line = 2'000'000'000;
  EXPECT_FALSE(collector.add(piece));
  EXPECT_EQ(collector.bad_pieces(), 5U);
  EXPECT_EQ(collector.take()[0].missing_beams, 50);
}

TEST(LineCollector, AnotherNumberingBeginsAnew) {
  LineCollector collector(10);
  collector.add(piece_of(1, 0, 100));
  LinePiece piece = piece_of(1, 0, 100);
  piece.numbered_since = 77;
  collector.add(piece);
  EXPECT_EQ(collector.lines(), 1U);
  for (int number = 2; number < 50; ++number) {
    piece = piece_of(number, 0, 100);
    piece.numbered_since = 77;
    collector.add(piece);
  }
  EXPECT_EQ(collector.lines(), 10U) << "the oldest go";
}

}  // namespace
}  // namespace scanway
