#pragma once

#include <cstdint>

#include "modules/planner/core/body/frame.h"
#include "modules/planner/core/body/lazy_array.h"
#include "modules/planner/core/body/spans.h"

namespace scanway::planning {

/// One bit a cell, 64 of a row to a word.
class BitGrid {
 public:
  explicit BitGrid(const Frame& frame) : words_a_row_(frame.width / 64), words_(frame.cells() / 64) {}

  std::uint64_t word(std::int32_t row, std::int32_t column) const { return words_[at(row, column)]; }
  void set_word(std::int32_t row, std::int32_t column, std::uint64_t word) { words_[at(row, column)] = word; }
  void fill() {
    for (std::size_t i = 0; i < words_.size(); ++i) words_[i] = ~std::uint64_t{0};
  }
  bool test(std::int32_t x, std::int32_t y) const { return (word(y, x >> 6) >> (x & 63)) & 1; }

  /// Whether any cell of [x0, x1] in row y is set. Coordinates from the frame's corner.
  bool any(std::int32_t y, std::int32_t x0, std::int32_t x1) const {
    const std::uint64_t* row = &words_[at(y, 0)];
    const std::int32_t first = x0 >> 6;
    const std::int32_t last = x1 >> 6;
    const std::uint64_t head = ~std::uint64_t{0} << (x0 & 63);
    const std::uint64_t tail = ~std::uint64_t{0} >> (63 - (x1 & 63));
    if (first == last) return (row[first] & head & tail) != 0;
    if ((row[first] & head) != 0 || (row[last] & tail) != 0) return true;
    for (std::int32_t i = first + 1; i < last; ++i) {
      if (row[i] != 0) return true;
    }
    return false;
  }
  bool any(const Spans& spans, std::int32_t x, std::int32_t y) const {
    for (const Span& span : spans) {
      if (any(y + span.y, x + span.x0, x + span.x1)) return true;
    }
    return false;
  }

 private:
  std::size_t at(std::int32_t row, std::int32_t column) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(words_a_row_) + static_cast<std::size_t>(column);
  }

  std::int32_t words_a_row_;
  LazyArray<std::uint64_t> words_;
};

}  // namespace scanway::planning
