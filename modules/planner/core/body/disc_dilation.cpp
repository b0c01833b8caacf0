#include "modules/planner/core/body/disc_dilation.h"

#include <algorithm>
#include <cmath>

namespace scanway::planning {
namespace {

constexpr double kRounding = 1e-9;

/// How far to the side a square may lie whose row is `dy` rows away, and still reach into the disc.
std::int32_t half_width(double radius, std::int32_t dy) {
  const double rise = std::max(dy - 0.5, 0.0);
  const double rest = radius * radius - rise * rise;
  if (rest <= kRounding) return -1;
  return static_cast<std::int32_t>(std::ceil(std::sqrt(rest) + 0.5 - kRounding)) - 1;
}

std::vector<std::int32_t> half_widths(double radius, std::int32_t reach) {
  std::vector<std::int32_t> widths;
  for (std::int32_t dy = 0; dy <= reach; ++dy) widths.push_back(half_width(radius, dy));
  return widths;
}

/// The word whose bit i is bit i + shift of the row that `words` is the middle of.
std::uint64_t shifted(const std::uint64_t* middle, std::int32_t shift) {
  const std::int32_t word = shift >> 6;
  const std::int32_t bit = shift & 63;
  if (bit == 0) return middle[word];
  return (middle[word] >> bit) | (middle[word + 1] << (64 - bit));
}

}  // namespace

DiscDilation::DiscDilation(double small, double large)
    : reach_(std::max(0, static_cast<std::int32_t>(std::ceil(large + 0.5)))),
      small_(half_widths(small, reach_)),
      large_(half_widths(large, reach_)) {}

void DiscDilation::widen(const BitGrid& grid, std::int32_t row, std::int32_t column,
                         std::vector<std::uint64_t>& by_width) const {
  const std::int32_t side = (reach_ + 63) / 64 + 1;
  std::array<std::uint64_t, 64> window{};
  std::vector<std::uint64_t> wide;
  std::uint64_t* words = window.data();
  if (2 * side + 1 > 64) {
    wide.resize(static_cast<std::size_t>(2 * side + 1));
    words = wide.data();
  }
  std::uint64_t any = 0;
  for (std::int32_t i = -side + 1; i < side; ++i) any |= words[i + side] = grid.word(row, column + i);
  if (any == 0) {
    std::fill(by_width.begin(), by_width.end(), 0);
    return;
  }
  by_width[0] = words[side];
  for (std::int32_t width = 1; width <= reach_; ++width) {
    by_width[static_cast<std::size_t>(width)] =
        by_width[static_cast<std::size_t>(width) - 1] | shifted(words + side, width) | shifted(words + side, -width);
  }
}

DiscDilation::Result DiscDilation::around(const BitGrid& grid, std::int32_t row, std::int32_t column) const {
  Result result{};
  std::vector<std::uint64_t> by_width(static_cast<std::size_t>(reach_) + 1);
  for (std::int32_t source = row - reach_; source < row + 64 + reach_; ++source) {
    widen(grid, source, column, by_width);
    if (by_width.back() == 0) continue;
    for (std::int32_t target = std::max(0, source - row - reach_); target <= std::min(63, source - row + reach_);
         ++target) {
      const auto dy = static_cast<std::size_t>(std::abs(row + target - source));
      if (small_[dy] >= 0)
        result.small[static_cast<std::size_t>(target)] |= by_width[static_cast<std::size_t>(small_[dy])];
      if (large_[dy] >= 0)
        result.large[static_cast<std::size_t>(target)] |= by_width[static_cast<std::size_t>(large_[dy])];
    }
  }
  return result;
}

}  // namespace scanway::planning
