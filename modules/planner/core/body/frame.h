#pragma once

#include <cstddef>
#include <cstdint>

#include "common/grid/bounds.h"
#include "common/grid/cost_map.h"

namespace scanway::planning {

/// A rectangle of cells in memory: block after block of 64 x 64 cells, in a block row after row. What the search looks
/// at together lies together, and blocks that it never enters cost no memory. Its corner and its sides are multiples of
/// 64.
class Frame {
 public:
  static constexpr std::int32_t kBlock = 64;
  static constexpr std::uint32_t kBlockCells = 64 * 64;

  Frame(Cell corner, std::int32_t cells_wide, std::int32_t cells_high)
      : low(corner),
        width(cells_wide),
        height(cells_high),
        blocks_a_row_(static_cast<std::uint32_t>(cells_wide / kBlock)),
        reciprocal_((std::uint64_t{1} << kReciprocalShift) / blocks_a_row_ + 1) {}

  std::size_t cells() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
  bool contains(Cell cell) const {
    return cell.x >= low.x && cell.y >= low.y && cell.x - low.x < width && cell.y - low.y < height;
  }
  std::uint32_t index(Cell cell) const { return index_of_offset({cell.x - low.x, cell.y - low.y}); }
  Cell cell(std::uint32_t index) const {
    const Cell at = offset_of(index);
    return {low.x + at.x, low.y + at.y};
  }

  /// The same for cells counted from the frame's corner.
  std::uint32_t index_of_offset(Cell at) const {
    const auto x = static_cast<std::uint32_t>(at.x);
    const auto y = static_cast<std::uint32_t>(at.y);
    return ((y >> 6) * blocks_a_row_ + (x >> 6)) << 12 | (y & 63) << 6 | (x & 63);
  }
  Cell offset_of(std::uint32_t index) const {
    const std::uint64_t block = index >> 12;
    const std::uint64_t row = block * reciprocal_ >> kReciprocalShift;
    return {static_cast<std::int32_t>((block - row * blocks_a_row_) << 6 | (index & 63)),
            static_cast<std::int32_t>(row << 6 | (index >> 6 & 63))};
  }

  /// Whether the eight cells around this one are in its block.
  static bool is_inner(std::uint32_t index) {
    return ((index + 1) & 63) >= 2 && ((index + kBlock) & (kBlockCells - 1)) >= 2 * kBlock;
  }
  /// From an inner cell to the one that is (dx, dy) from it.
  static constexpr std::int32_t inner_step(std::int32_t dx, std::int32_t dy) { return dy * kBlock + dx; }
  /// The cell that is (dx, dy) from this one.
  std::uint32_t beside(std::uint32_t index, std::int32_t dx, std::int32_t dy) const {
    if (is_inner(index)) return index + static_cast<std::uint32_t>(inner_step(dx, dy));
    const Cell at = offset_of(index);
    return index_of_offset({at.x + dx, at.y + dy});
  }

  Cell low;
  std::int32_t width;
  std::int32_t height;

 private:
  /// Exact, as there are fewer than 2^20 blocks.
  static constexpr int kReciprocalShift = 40;
  std::uint32_t blocks_a_row_;
  std::uint64_t reciprocal_;  ///< 2^40 / blocks_a_row_, rounded up.
};

/// With room for tiles that appear around `bounds`, and for looking `reach` cells beyond them. Throws std::length_error
/// for more than 3 * 2^30 cells.
Frame frame_around(const CellRectangle& bounds, std::int32_t reach);

}  // namespace scanway::planning
