#include "modules/mapper/core/registration/cell_order.h"

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

namespace scanway::registration {
namespace {

constexpr int kDigitBits = 11, kCoordinateBits = 21;
constexpr CellKey kDigit = (CellKey{1} << kDigitBits) - 1;

/// The key of the lowest x, y and z: less it, cells differ in few bits, and their order is the same.
CellKey lowest_corner(const std::vector<KeyedIndex>& entries) {
  CellKey corner = 0;
  for (int shift = 0; shift < 3 * kCoordinateBits; shift += kCoordinateBits) {
    const CellKey mask = ((CellKey{1} << kCoordinateBits) - 1) << shift;
    CellKey lowest = mask;
    for (const KeyedIndex& entry : entries) lowest = std::min(lowest, entry.key & mask);
    corner |= lowest;
  }
  return corner;
}

void sort_by_digit(const std::vector<KeyedIndex>& from, std::vector<KeyedIndex>& to, CellKey corner, int shift) {
  std::array<std::uint32_t, kDigit + 1> begin{};
  const auto digit = [&](const KeyedIndex& entry) { return (entry.key - corner) >> shift & kDigit; };
  for (const KeyedIndex& entry : from) ++begin[digit(entry)];
  std::uint32_t sum = 0;
  for (std::uint32_t& b : begin) sum += std::exchange(b, sum);
  for (const KeyedIndex& entry : from) to[begin[digit(entry)]++] = entry;
}

}  // namespace

void sort_by_cell(std::vector<KeyedIndex>& entries) {
  const CellKey corner = lowest_corner(entries);
  CellKey differing = 0;
  for (const KeyedIndex& entry : entries) differing |= entry.key - corner;
  std::vector<KeyedIndex> other(entries.size());
  while (differing != 0) {
    const int shift = std::countr_zero(differing);
    sort_by_digit(entries, other, corner, shift);
    entries.swap(other);
    differing &= ~(kDigit << shift);
  }
}

}  // namespace scanway::registration
