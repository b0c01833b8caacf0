#include "common/grid/bounds.h"

#include <algorithm>

namespace scanway {
namespace {

bool is_known(CellState state) { return state != CellState::unknown; }

/// Makes `known` hold the known cells of one more tile.
void extend(std::optional<CellRectangle>& known, Cell tile, const CostTile& cells) {
  constexpr std::int32_t kSide = CostTile::kSide;
  for (std::int32_t row = 0; row < kSide; ++row) {
    const auto begin = cells.state.begin() + static_cast<std::ptrdiff_t>(row) * kSide;
    const auto first = std::find_if(begin, begin + kSide, is_known);
    if (first == begin + kSide) continue;
    const auto last =
        std::find_if(std::make_reverse_iterator(begin + kSide), std::make_reverse_iterator(first), is_known);
    const auto low = static_cast<std::int32_t>(first - begin), high = static_cast<std::int32_t>(last.base() - begin);
    const std::int32_t x = tile.x * kSide, y = tile.y * kSide + row;
    const CellRectangle here{{x + low, y}, {x + high, y + 1}};
    if (!known) known = here;
    known->low = {std::min(known->low.x, here.low.x), std::min(known->low.y, here.low.y)};
    known->high = {std::max(known->high.x, here.high.x), std::max(known->high.y, here.high.y)};
  }
}

}  // namespace

std::optional<CellRectangle> bounds(const CostMap& map) {
  std::optional<CellRectangle> known;
  for (const auto& [tile, cells] : map.tiles) extend(known, tile, cells);
  return known;
}

}  // namespace scanway
