#include "modules/tools/map/octree_projection.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "common/files/input_error.h"
#include "common/files/printable.h"
#include "common/grid/bounds.h"

namespace scanway::tools {
namespace {

constexpr std::int64_t kMostCells = 36'000'000;
constexpr double kRounding = 1e-6;  // Of a voxel.

/// Voxels by their number along z, from `first` up to and without `end`.
struct Layer {
  std::int32_t first = 0, end = 0;
  bool meets(const OctreeLeaf& leaf) const { return leaf.low[2] < end && leaf.low[2] + leaf.side > first; }
};

/// What the body meets, from below to above.
struct Layers {
  Layer below_ground, ground, above_ground, body;
};

Layers layers_of(const OctreeFile& tree, const BodyBand& band) {
  const double voxel = tree.resolution_m();
  const auto at = [&](double z_m) { return (band.ground_z_m + z_m) / voxel; };
  // The voxel that begins above the climbable step, and the one that holds the ground.
  const auto above = static_cast<std::int32_t>(std::floor(at(band.climbable_step_m) + kRounding)) + 1;
  const auto ground = static_cast<std::int32_t>(std::floor(at(0.0) - kRounding));
  const auto top = static_cast<std::int32_t>(std::ceil(at(band.height_m) - kRounding));
  return {{ground - 1, ground}, {ground, above}, {above, above + 1}, {above, std::max(top, above + 1)}};
}

/// What is known of a cell's column, as bits.
enum Sign : std::uint8_t { kObstacle = 1, kDrop = 2, kGround = 4, kClear = 8 };

std::uint8_t signs_of(const OctreeLeaf& leaf, const Layers& layers) {
  std::uint8_t signs = 0;
  if (leaf.occupied && layers.body.meets(leaf)) signs |= kObstacle;
  if (leaf.occupied && layers.ground.meets(leaf)) signs |= kGround;
  if (!leaf.occupied && layers.above_ground.meets(leaf)) signs |= kClear;
  if (!leaf.occupied && layers.below_ground.meets(leaf)) signs |= kDrop;
  return signs;
}

CellState state_of(std::uint8_t signs) {
  const bool has_ground = (signs & kGround) != 0;
  if ((signs & kObstacle) != 0 || ((signs & kDrop) != 0 && !has_ground)) return CellState::occupied;
  return (signs & kClear) != 0 || has_ground ? CellState::free : CellState::unknown;
}

/// The signs of all cells of a rectangle.
class Columns {
 public:
  explicit Columns(const CellRectangle& extent)
      : extent_(extent), signs_(static_cast<std::size_t>(extent.width() * extent.height())) {}

  void add(const OctreeLeaf& leaf, std::uint8_t signs) {
    for (std::int32_t y = leaf.low[1]; y < leaf.low[1] + leaf.side; ++y) {
      for (std::int32_t x = leaf.low[0]; x < leaf.low[0] + leaf.side; ++x) signs_[index({x, y})] |= signs;
    }
  }
  CostMap map(double resolution_m) const {
    CostMap map;
    map.resolution_m = resolution_m;
    for (std::int32_t y = extent_.low.y; y < extent_.high.y; ++y) {
      for (std::int32_t x = extent_.low.x; x < extent_.high.x; ++x) {
        const CellState state = state_of(signs_[index({x, y})]);
        if (state != CellState::unknown) map.set_state({x, y}, state);
      }
    }
    return map;
  }

 private:
  std::size_t index(Cell cell) const {
    return static_cast<std::size_t>((cell.y - extent_.low.y) * extent_.width() + (cell.x - extent_.low.x));
  }

  CellRectangle extent_;
  std::vector<std::uint8_t> signs_;
};

void widen(std::optional<CellRectangle>& extent, const OctreeLeaf& leaf) {
  const Cell low{leaf.low[0], leaf.low[1]}, high{leaf.low[0] + leaf.side, leaf.low[1] + leaf.side};
  if (!extent) extent = {low, high};
  extent->low = {std::min(extent->low.x, low.x), std::min(extent->low.y, low.y)};
  extent->high = {std::max(extent->high.x, high.x), std::max(extent->high.y, high.y)};
}

}  // namespace

CostMap project(const OctreeFile& tree, const BodyBand& band, const std::string& name) {
  const Layers layers = layers_of(tree, band);
  std::optional<CellRectangle> extent;
  tree.for_each_leaf([&](const OctreeLeaf& leaf) {
    if (signs_of(leaf, layers) != 0) widen(extent, leaf);
  });
  if (!extent) return CostMap{tree.resolution_m(), 0.0, 0.0, {}};
  if (extent->width() * extent->height() > kMostCells) {
    throw InputError(
        fmt::format("{}: spreads over {} x {} cells of {} m, more than {} million; cut out the part to plan on",
                    printable(name), extent->width(), extent->height(), tree.resolution_m(), kMostCells / 1'000'000));
  }
  Columns columns(*extent);
  tree.for_each_leaf([&](const OctreeLeaf& leaf) {
    if (const std::uint8_t signs = signs_of(leaf, layers); signs != 0) columns.add(leaf, signs);
  });
  return columns.map(tree.resolution_m());
}

}  // namespace scanway::tools
