#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace scanway {

/// Sorts entries by their 64-bit member `key`, stable. Eleven bits a pass; passes whose bits are equal in all entries
/// are skipped, which for the keys of one site are most of the upper ones.
template <class Entry>
void radix_sort_by_key(std::vector<Entry>& entries) {
  constexpr int kBits = 11;
  constexpr std::uint64_t kMask = (std::uint64_t{1} << kBits) - 1;
  std::uint64_t differing = 0;
  for (const Entry& entry : entries) differing |= entry.key ^ entries.front().key;

  std::vector<Entry> sorted(entries.size());
  for (int shift = 0; shift < 64; shift += kBits) {
    if (((differing >> shift) & kMask) == 0) continue;
    std::array<std::size_t, kMask + 2> begin{};
    for (const Entry& entry : entries) ++begin[((entry.key >> shift) & kMask) + 1];
    for (std::size_t digit = 0; digit <= kMask; ++digit) begin[digit + 1] += begin[digit];
    for (const Entry& entry : entries) sorted[begin[(entry.key >> shift) & kMask]++] = entry;
    entries.swap(sorted);
  }
}

}  // namespace scanway
