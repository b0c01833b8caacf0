#include "modules/mapper/core/costmap/occupancy_window.h"

#include <algorithm>

namespace scanway {

OccupancyWindow OccupancyWindow::of(const CostMap& map, Cell corner, int width, int height) {
  OccupancyWindow window{corner, width, height, {}, false};
  window.occupied.assign(static_cast<std::size_t>(width) * height, 0);
  constexpr std::int32_t side = CostTile::kSide;
  const Cell first = CostMap::tile_of(corner);
  const Cell last = CostMap::tile_of({corner.x + width - 1, corner.y + height - 1});
  for (std::int32_t ty = first.y; ty <= last.y; ++ty) {
    for (std::int32_t tx = first.x; tx <= last.x; ++tx) {
      const auto tile = map.tiles.find({tx, ty});
      if (tile == map.tiles.end()) continue;
      const std::int32_t x0 = std::max(corner.x, tx * side), x1 = std::min(corner.x + width, (tx + 1) * side);
      const std::int32_t y0 = std::max(corner.y, ty * side), y1 = std::min(corner.y + height, (ty + 1) * side);
      for (std::int32_t y = y0; y < y1; ++y) {
        const CellState* from = &tile->second.state[static_cast<std::size_t>(y - ty * side) * side + (x0 - tx * side)];
        std::uint8_t* to = &window.occupied[static_cast<std::size_t>(y - corner.y) * width + (x0 - corner.x)];
        std::uint8_t seen = 0;
        for (std::int32_t i = 0; i < x1 - x0; ++i) seen |= to[i] = from[i] == CellState::occupied ? 1 : 0;
        window.any = window.any || seen != 0;
      }
    }
  }
  return window;
}

}  // namespace scanway
