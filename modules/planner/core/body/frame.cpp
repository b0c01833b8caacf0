#include "modules/planner/core/body/frame.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace scanway::planning {
namespace {

/// Tiles around the map that may still appear before the frame must be made anew. What is never touched costs no
/// memory.
constexpr std::int64_t kMostGrowth = 8;

std::int32_t round_down(std::int32_t x, std::int32_t step) {
  return static_cast<std::int32_t>(std::floor(static_cast<double>(x) / step)) * step;
}

}  // namespace

Frame frame_around(const CellRectangle& bounds, std::int32_t reach) {
  const auto growth = std::min(kMostGrowth, 1 + std::max(bounds.width(), bounds.height()) / CostTile::kSide);
  const std::int32_t margin = (static_cast<std::int32_t>(growth) + reach / CostTile::kSide + 1) * CostTile::kSide;
  const Cell low = {round_down(bounds.low.x, CostTile::kSide) - margin,
                    round_down(bounds.low.y, CostTile::kSide) - margin};
  const std::int64_t width = round_down(bounds.high.x - 1, CostTile::kSide) + CostTile::kSide + margin - low.x;
  const std::int64_t height = round_down(bounds.high.y - 1, CostTile::kSide) + CostTile::kSide + margin - low.y;
  if (width * height > std::int64_t{3} << 30) throw std::length_error("the map is too large to plan on");
  return {low, static_cast<std::int32_t>(width), static_cast<std::int32_t>(height)};
}

}  // namespace scanway::planning
