#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "common/math/repeatable.h"
#include "modules/mapper/core/costmap/tile_costs.h"

namespace scanway {
namespace {

constexpr int kSide = CostTile::kSide;
constexpr int kReach = PaperCosts::kReach;

/// Calls visit(x) for each occupied cell of row[0, count).
template <class Visit>
inline void for_occupied(const CellState* row, int count, const Visit& visit) {
  static_assert(static_cast<int>(CellState::occupied) == 2 && std::endian::native == std::endian::little);
  constexpr std::uint64_t kOccupied = 0x0202020202020202;
  int x = 0;
  for (; x + 8 <= count; x += 8) {
    std::uint64_t eight;
    std::memcpy(&eight, row + x, 8);
    for (eight &= kOccupied; eight != 0; eight &= eight - 1) visit(x + std::countr_zero(eight) / 8);
  }
  for (; x < count; ++x) {
    if (row[x] == CellState::occupied) visit(x);
  }
}

/// Sums of kernels around obstacles, with room at the sides, so that no row of a kernel needs its ends cut.
class Sums {
 public:
  Sums(const std::uint32_t* kernel, int stride) : kernel_(kernel), stride_(stride) {}

  /// An obstacle at (x, y) in the tile's cells or up to kReach beside it.
  void add(int x, int y) {
    if (!any_) std::fill(sums_.begin(), sums_.end(), 0);
    any_ = true;
    const int first = std::max(y - kReach, 0), last = std::min(y + kReach, kSide - 1);
    for (int row = first; row <= last; ++row) {
      std::uint32_t* sum = &sums_[static_cast<std::size_t>(row * kWidth + x + kReach)];
      const std::uint32_t* from = kernel_ + (row - y + kReach) * stride_;
      for (int i = 0; i < 12; ++i) sum[i] += from[i];
    }
  }

  bool any() const { return any_; }
  void copy_to(TileCosts& costs) const {
    for (int y = 0; y < kSide; ++y) {
      std::copy_n(&sums_[static_cast<std::size_t>(y * kWidth + 2 * kReach)], kSide,
                  &costs[static_cast<std::size_t>(y * kSide)]);
    }
  }

 private:
  static constexpr int kWidth = kSide + 4 * kReach + 4;

  const std::uint32_t* kernel_;
  int stride_;
  bool any_ = false;
  std::array<std::uint32_t, static_cast<std::size_t>(kSide) * kWidth> sums_;
};

}  // namespace

PaperCosts::PaperCosts() {
  for (int dy = -kReach; dy <= kReach; ++dy) {
    for (int dx = -kReach; dx <= kReach; ++dx) {
      const double value = repeatable::exp(-0.5 * (dx * dx + dy * dy)) * kCostOne;
      kernel_[static_cast<std::size_t>((dy + kReach) * kStride + dx + kReach)] =
          static_cast<std::uint32_t>(std::floor(value + 0.5));
    }
  }
}

bool PaperCosts::of_tile(const CostMap& map, Cell tile, TileCosts& costs) const {
  Sums sums(kernel_.data(), kStride);
  for (int ty = -1; ty <= 1; ++ty) {
    for (int tx = -1; tx <= 1; ++tx) {
      const auto neighbour = map.tiles.find({tile.x + tx, tile.y + ty});
      if (neighbour == map.tiles.end()) continue;
      const int x0 = tx < 0 ? kSide - kReach : 0, x1 = tx > 0 ? kReach : kSide;
      const int y0 = ty < 0 ? kSide - kReach : 0, y1 = ty > 0 ? kReach : kSide;
      for (int y = y0; y < y1; ++y) {
        const CellState* row = &neighbour->second.state[static_cast<std::size_t>(y * kSide + x0)];
        for_occupied(row, x1 - x0, [&](int x) { sums.add(tx * kSide + x0 + x, ty * kSide + y); });
      }
    }
  }
  if (sums.any()) sums.copy_to(costs);
  return sums.any();
}

}  // namespace scanway
