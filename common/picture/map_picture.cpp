#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "common/files/atomic_file.h"
#include "common/picture/canvas.h"
#include "common/picture/map_raster.h"
#include "common/picture/pictures.h"

namespace scanway {
namespace {

constexpr Colour kRed = {222, 32, 38};
constexpr Colour kPurple = {128, 36, 168};
constexpr CellRectangle kNothing{{0, 0}, {200, 100}};

/// The known part of the map, and one more cell on each side.
CellRectangle known_part(const CostMap& map) {
  auto part = bounds(map).value_or(kNothing);
  return {{part.low.x - 1, part.low.y - 1}, {part.high.x + 1, part.high.y + 1}};
}

void grow(Eigen::AlignedBox2d& box, const std::vector<Eigen::Vector2d>& points) {
  for (const Eigen::Vector2d& point : points) box.extend(point);
}

/// The cells around the paths: on a large map a path would be a scratch else.
CellRectangle part_around(const CostMap& map, const PathPicture& paths) {
  Eigen::AlignedBox2d box(paths.start_m);
  box.extend(paths.goal_m);
  grow(box, paths.without_embodiment);
  grow(box, paths.with_embodiment);
  const double border_m = std::max(0.25 * box.sizes().maxCoeff(), 2.0);
  const Eigen::Vector2d origin(map.origin_x_m, map.origin_y_m), border(border_m, border_m);
  const CellRectangle known = known_part(map);
  const auto cell_at = [&](const Eigen::Vector2d& at_m) {
    const Eigen::Vector2d cell = ((at_m - origin) / map.resolution_m).array().floor();
    return Cell{static_cast<std::int32_t>(std::clamp<double>(cell.x(), known.low.x, known.high.x)),
                static_cast<std::int32_t>(std::clamp<double>(cell.y(), known.low.y, known.high.y))};
  };
  const Cell low = cell_at(box.min() - border), high = cell_at(box.max() + border);
  const CellRectangle part{{std::max(low.x, known.low.x), std::max(low.y, known.low.y)},
                           {std::min(high.x, known.high.x), std::min(high.y, known.high.y)}};
  return part.width() > 0 && part.height() > 0 ? part : known;
}

bool has_cost(const CostMap& map) {
  return std::ranges::any_of(map.tiles, [](const auto& tile) {
    return std::ranges::any_of(tile.second.cost, [](std::uint32_t cost) { return cost > 0; });
  });
}

void legend_of_cells(Canvas& canvas, const CostMap& map) {
  canvas.legend_field(kFreeColour, "free");
  canvas.legend_field(kUnknownColour, "unknown");
  canvas.legend_field(kOccupiedColour, "occupied");
  if (!has_cost(map)) return;
  canvas.legend_field(kDearestColour, "near an obstacle");
  canvas.legend_field(kLethalColour, "too near");
}

}  // namespace

void draw_cost_map(const std::string& path, const CostMap& map) {
  Canvas canvas(raster_of(map, known_part(map)));
  if (!bounds(map)) canvas.note("nothing is known");
  legend_of_cells(canvas, map);
  write_file(path, canvas.png());
}

void draw_path(const std::string& path, const CostMap& map, const PathPicture& paths) {
  Canvas canvas(raster_of(map, part_around(map, paths)));
  canvas.polyline(paths.without_embodiment, kRed);
  canvas.polyline(paths.with_embodiment, kPurple);
  canvas.start_mark(paths.start_m);
  canvas.goal_mark(paths.goal_m);
  if (!paths.without_embodiment.empty()) canvas.legend_line(kRed, "without embodiment");
  if (!paths.with_embodiment.empty()) canvas.legend_line(kPurple, "with embodiment");
  canvas.legend_marks();
  write_file(path, canvas.png());
}

}  // namespace scanway
