#include "modules/mapper/core/registration/compatibility.h"

#include <bit>

namespace scanway::registration {
namespace {

__attribute__((target_clones("default", "popcnt"))) std::size_t count_common(const std::uint64_t* a,
                                                                             const std::uint64_t* b,
                                                                             std::size_t words) {
  std::size_t count = 0;
  for (std::size_t w = 0; w < words; ++w) count += static_cast<std::size_t>(std::popcount(a[w] & b[w]));
  return count;
}

}  // namespace

void Compatibility::mirror() {
  for (std::size_t i = 0; i < size_; ++i) {
    for (std::size_t w = i / 64; w < words_; ++w) {
      for (std::uint64_t bits = row(i)[w]; bits != 0; bits &= bits - 1) {
        const std::size_t j = 64 * w + static_cast<std::size_t>(std::countr_zero(bits));
        if (j > i) set(j, i);
      }
    }
  }
}

std::size_t Compatibility::common(std::size_t i, std::size_t j) const { return count_common(row(i), row(j), words_); }

}  // namespace scanway::registration
