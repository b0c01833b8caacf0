#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "modules/mapper/core/assembly/scan_line.h"

namespace scanway {

/// Some beams of a line, one after the other; what it says of the line, every piece of the line says.
struct LinePiece {
  ScanLine line;                    ///< With the counts of this piece's beams only.
  std::int64_t numbered_since = 0;  ///< Another value is another numbering: what was before it can never be completed.
  std::int32_t beams_of_line = 0;
  std::int32_t first_beam = 0;
};

/// Puts lines together from pieces that come in any order, twice, or not at all.
class LineCollector {
 public:
  /// `most_lines`: when more are held, the oldest go.
  explicit LineCollector(std::size_t most_lines = 20'000) : most_lines_(most_lines) {}

  /// False for a piece that contradicts itself or its line; it is not taken.
  bool add(const LinePiece& piece);

  /// From one line to the next, and from the first to the last that came: what is missing. Pairs of the first and the
  /// last number of a stretch in which every line is missing or lacks beams.
  std::vector<std::pair<std::int64_t, std::int64_t>> missing() const;

  /// All lines, by number, whole or not; the collector is empty then.
  std::vector<ScanLine> take();
  /// Those that began before `utime`.
  std::vector<ScanLine> take_before(Utime utime);

  std::size_t lines() const { return lines_.size(); }
  std::size_t bad_pieces() const { return bad_pieces_; }
  std::size_t repeated_pieces() const { return repeated_pieces_; }

 private:
  struct Line {
    ScanLine line;
    std::vector<bool> came;
  };

  std::size_t most_lines_;
  std::optional<std::int64_t> numbered_since_;
  std::map<std::int64_t, Line> lines_;
  std::size_t bad_pieces_ = 0, repeated_pieces_ = 0;
};

}  // namespace scanway
