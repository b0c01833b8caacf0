#include "modules/simulator/core/truth/truth_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/parallel/blocks.h"
#include "modules/simulator/core/truth/rasterizer.h"

namespace scanway::simulator {
namespace {

constexpr std::int32_t kRowsAtOnce = 64;

/// All triangles of a world, seen from above.
struct FlatWorld {
  explicit FlatWorld(const World& world) : ground(flattened(world.ground)), objects(flattened(world.objects)) {}

  static std::vector<FlatTriangle> flattened(const Mesh& mesh) {
    std::vector<FlatTriangle> triangles;
    triangles.reserve(mesh.size());
    for (std::size_t i = 0; i < mesh.size(); ++i) triangles.emplace_back(mesh.corners(i));
    return triangles;
  }

  std::vector<FlatTriangle> ground, objects;
};

/// Some rows of the grid, with one more cell all round for the neighbours.
class Strip {
 public:
  Strip(const World& world, const Robot::Body& body, const CellWindow& wide)
      : world_(world),
        body_(body),
        window_(wide),
        ground_(wide.size(), std::numeric_limits<double>::quiet_NaN()),
        inside_(wide.size(), 0),
        touched_(wide.size(), false) {}

  void fill(const FlatWorld& flat) {
    for (const FlatTriangle& triangle : flat.ground) add_ground(triangle);
    for (std::size_t i = 0; i < flat.objects.size(); ++i) {
      const FlatTriangle& triangle = flat.objects[i];
      if (misses(triangle)) continue;
      add_shell(world_.objects.corners(i), triangle);
      if (world_.objects.surface(i).solid) add_inside(triangle);
    }
  }

  CellTruth truth(std::int32_t x, std::int32_t y) const {
    const std::size_t i = window_.index(x, y);
    if (std::isnan(ground_[i])) return CellTruth::unknown;
    if (touched_[i] || inside_[i] > 0) return CellTruth::occupied;
    double up = 0.0, down = 0.0;
    for (std::int32_t ny = y - 1; ny <= y + 1; ++ny) {
      for (std::int32_t nx = x - 1; nx <= x + 1; ++nx) {
        const double step = ground_[window_.index(nx, ny)] - ground_[i];
        if (step > up) up = step;
        if (-step > down) down = -step;
      }
    }
    if (up > body_.climbable_step_m) return CellTruth::occupied;
    return down > kDropOff_m ? CellTruth::drop_off : CellTruth::free;
  }

 private:
  bool misses(const FlatTriangle& triangle) const {
    return triangle.high(1) < window_.low_y * window_.resolution_m ||
           triangle.low(1) > window_.high_y * window_.resolution_m ||
           triangle.high(0) < window_.low_x * window_.resolution_m ||
           triangle.low(0) > window_.high_x * window_.resolution_m;
  }

  void add_ground(const FlatTriangle& triangle) {
    if (misses(triangle)) return;
    for_centres(triangle, window_, [&](std::int32_t x, std::int32_t y, double z) {
      double& ground = ground_[window_.index(x, y)];
      if (!(z <= ground)) ground = z;
      highest_ = std::max(highest_, z);
    });
  }

  /// Cells that the surface passes through where the body could meet it.
  void add_shell(const Corners& corners, const FlatTriangle& triangle) {
    if (triangle.low(2) >= highest_ + body_.height_m) return;
    for_touched(corners, window_, [&](std::int32_t x, std::int32_t y, double low, double high) {
      const std::size_t i = window_.index(x, y);
      if (high > ground_[i] + body_.climbable_step_m && low < ground_[i] + body_.height_m) touched_[i] = true;
    });
  }

  /// Counts, for the point just above what can be climbed, the surfaces over it that lead out of a closed body, less
  /// those that lead into one: more than 0 is inside.
  void add_inside(const FlatTriangle& triangle) {
    for_centres(triangle, window_, [&](std::int32_t x, std::int32_t y, double z) {
      const std::size_t i = window_.index(x, y);
      if (z > ground_[i] + body_.climbable_step_m) inside_[i] += triangle.facing();
    });
  }

  const World& world_;
  const Robot::Body& body_;
  CellWindow window_;
  std::vector<double> ground_;
  std::vector<int> inside_;
  std::vector<bool> touched_;
  double highest_ = -std::numeric_limits<double>::infinity();
};

}  // namespace

CellTruth TruthGrid::at(Cell cell) const {
  const std::int32_t x = cell.x - low.x, y = cell.y - low.y;
  if (x < 0 || y < 0 || x >= width || y >= height) return CellTruth::unknown;
  return cells[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
}

CellTruth TruthGrid::at(double x, double y) const {
  return at(Cell{static_cast<std::int32_t>(std::floor(x / resolution_m)),
                 static_cast<std::int32_t>(std::floor(y / resolution_m))});
}

TruthGrid make_truth(const World& world, const Robot::Body& body, double resolution_m,
                     std::optional<Rectangle> window) {
  const Rectangle part = window.value_or(world.extent);
  CellWindow all{resolution_m, 0, 0, 0, 0};
  all.low_x = all.cell(part.low.x());
  all.low_y = all.cell(part.low.y());
  all.high_x = all.cell(part.high.x()) + 1;
  all.high_y = all.cell(part.high.y()) + 1;
  TruthGrid grid{resolution_m, {all.low_x, all.low_y}, all.width(), all.high_y - all.low_y, {}};
  grid.cells.resize(all.size());
  const FlatWorld flat(world);
  for_blocks(static_cast<std::size_t>(grid.height), kRowsAtOnce, [&](std::size_t begin, std::size_t end, std::size_t) {
    const std::int32_t y0 = all.low_y + static_cast<std::int32_t>(begin),
                       y1 = all.low_y + static_cast<std::int32_t>(end);
    Strip strip(world, body, {resolution_m, all.low_x - 1, y0 - 1, all.high_x + 1, y1 + 1});
    strip.fill(flat);
    for (std::int32_t y = y0; y < y1; ++y) {
      for (std::int32_t x = all.low_x; x < all.high_x; ++x) grid.cells[all.index(x, y)] = strip.truth(x, y);
    }
  });
  return grid;
}

CostMap to_cost_map(const TruthGrid& truth, bool only_drop_offs) {
  CostMap map;
  map.resolution_m = truth.resolution_m;
  for (std::int32_t y = 0; y < truth.height; ++y) {
    for (std::int32_t x = 0; x < truth.width; ++x) {
      const Cell cell{truth.low.x + x, truth.low.y + y};
      const CellTruth is = truth.at(cell);
      if (is == CellTruth::unknown) continue;
      const bool occupied = is == CellTruth::drop_off || (is == CellTruth::occupied && !only_drop_offs);
      map.set_state(cell, occupied ? CellState::occupied : CellState::free);
    }
  }
  return map;
}

}  // namespace scanway::simulator
