#include "modules/mapper/core/costmap/evidence.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "common/parallel/blocks.h"
#include "modules/mapper/core/cloud/map_points.h"
#include "modules/mapper/core/costmap/return_spots.h"

namespace scanway {
namespace {

Cell cell_at(double x, double y, double resolution) {
  return {static_cast<std::int32_t>(std::floor(x / resolution)), static_cast<std::int32_t>(std::floor(y / resolution))};
}

void count(std::uint8_t& counter) { counter = static_cast<std::uint8_t>(std::min(counter + 1, 255)); }

/// What is lower may lie between the beams of a far sweep.
constexpr double kLow_m = 0.1;

/// Counts the returns of each cell, and leaves kLowStep where they are all from something low.
void count_returns(SweepEvidence& evidence, const std::vector<ObstacleReturn>& obstacles, double resolution) {
  for (const ObstacleReturn& obstacle : obstacles) {
    const Cell cell = cell_at(obstacle.x, obstacle.y, resolution);
    EvidenceTile& tile = evidence[CostMap::tile_of(cell)];
    const std::size_t index = CostMap::index_in_tile(cell);
    const bool low =
        obstacle.above <= kLow_m && (tile.returns[index] == 0 || tile.beams[index] == EvidenceTile::kLowStep);
    tile.beams[index] = low ? EvidenceTile::kLowStep : 0;
    count(tile.returns[index]);
  }
}

/// What was seen of the ground, beside what stands on it.
void lay_under(EvidenceTile& tile, const EvidenceTile& ground) {
  tile.ground = ground.ground;
  for (std::size_t cell = 0; cell < CostTile::kCells; ++cell) {
    if (tile.returns[cell] == 0) tile.beams[cell] = ground.beams[cell];
  }
}

/// What the beams over one cell say.
std::uint8_t passed_over(double x, double y, const GroundSurface::Place& ground, const SweepView& view,
                         const DropView& drops) {
  const Eigen::Vector2d direction(x - view.origin().x(), y - view.origin().y());
  const polar::Place place(direction.x(), direction.y());
  if (!ground.carried) return view.seen_empty(place, ground) ? EvidenceTile::kEmpty : 0;
  const DropView::Way way = drops.way(place, direction, ground);
  switch (way.below) {
    case DropView::Below::drop:
      return EvidenceTile::kDrop;
    case DropView::Below::far_drop:
      return EvidenceTile::kFarDrop;
    case DropView::Below::unsure:
      return EvidenceTile::kUnsure;
    default:
      if (!view.seen_empty(place, ground)) return 0;
      return way.sparse ? EvidenceTile::kSparse : EvidenceTile::kEmpty;
  }
}

/// Whether anything was seen in the tile; `tile` then says what.
bool look_at_ground(Cell index, EvidenceTile& tile, const GroundSurface& ground, const SweepView& view,
                    const DropView& drops, double resolution) {
  bool any = false;
  for (std::int32_t row = 0; row < CostTile::kSide; ++row) {
    const double y = (index.y * CostTile::kSide + row + 0.5) * resolution;
    for (std::int32_t column = 0; column < CostTile::kSide; ++column) {
      const double x = (index.x * CostTile::kSide + column + 0.5) * resolution;
      const GroundSurface::Place place = ground.at(x, y);
      const std::size_t cell = static_cast<std::size_t>(row) * CostTile::kSide + column;
      if (place.carried) tile.ground[cell] = static_cast<std::uint8_t>(place.support);
      tile.beams[cell] = passed_over(x, y, place, view, drops);
      any = any || tile.beams[cell] != 0;
    }
  }
  return any;
}

bool contains(const std::vector<Eigen::Vector2d>& polygon, const Eigen::Vector2d& p) {
  bool inside = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Eigen::Vector2d &a = polygon[i], &b = polygon[j];
    if ((a.y() > p.y()) == (b.y() > p.y())) continue;
    if (p.x() < a.x() + (b.x() - a.x()) * (p.y() - a.y()) / (b.y() - a.y())) inside = !inside;
  }
  return inside;
}

double distance_to_outline(const std::vector<Eigen::Vector2d>& polygon, const Eigen::Vector2d& p) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Eigen::Vector2d a = polygon[j], along = polygon[i] - a;
    const double share = std::clamp((p - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
    least = std::min(least, (p - a - share * along).norm());
  }
  return least;
}

/// Around itself the robot's body hides the ground from its laser, about so far. There a beam that passes below the
/// body's height will do, where elsewhere it must pass close to the ground: else no robot could leave its first place.
constexpr double kOwnShadow_m = 0.12;

/// The ground below the body is free, and that in its shadow unless something stands there.
void stand(SweepEvidence& evidence, const Robot::Body& body, const Pose& X_map_sweep, double resolution) {
  std::vector<Eigen::Vector2d> corners;
  double reach = 0.0;
  const Eigen::Vector3d centre = X_map_sweep.translation();
  for (const Eigen::Vector2d& corner : body.footprint) {
    corners.push_back(transform_in_order(X_map_sweep, {corner.x(), corner.y(), 0.0}).head<2>());
    reach = std::max(reach, (corners.back() - centre.head<2>()).norm() + kOwnShadow_m);
  }
  const Cell low = cell_at(centre.x() - reach, centre.y() - reach, resolution);
  const Cell high = cell_at(centre.x() + reach, centre.y() + reach, resolution);
  for (std::int32_t y = low.y; y <= high.y; ++y) {
    for (std::int32_t x = low.x; x <= high.x; ++x) {
      const Eigen::Vector2d at((x + 0.5) * resolution, (y + 0.5) * resolution);
      const bool below = contains(corners, at);
      if (!below && distance_to_outline(corners, at) > kOwnShadow_m) continue;
      EvidenceTile& tile = evidence[CostMap::tile_of({x, y})];
      const std::size_t cell = CostMap::index_in_tile({x, y});
      if (!below && (tile.returns[cell] != 0 || tile.ground[cell] == 0 || tile.beams[cell] != 0)) continue;
      tile.returns[cell] = 0;
      tile.beams[cell] = below ? EvidenceTile::kEmpty : EvidenceTile::kOwnShadow;
      if (below) tile.ground[cell] = 1;
    }
  }
}

}  // namespace

Known EvidenceTile::over(Known before, std::size_t cell) const {
  if (returns[cell] > 0) return beams[cell] == kLowStep ? Known::low : Known::occupied;
  if (beams[cell] == kDrop) return Known::low;
  const bool seen_closely = before == Known::free || before >= Known::low;
  if (beams[cell] == kFarDrop) return seen_closely ? before : Known::low;
  if (beams[cell] == kUnsure) return seen_closely ? before : Known::suspected;
  if (ground[cell] == 0) return beams[cell] == kEmpty && before == Known::occupied ? Known::nothing : before;
  if (beams[cell] == kEmpty) return Known::free;
  if (beams[cell] == kOwnShadow) return before == Known::nothing ? Known::sparsely_free : before;
  if (beams[cell] == kSparse)
    return before == Known::nothing || before == Known::occupied ? Known::sparsely_free : before;
  return before;
}

SweepEvidence gather_evidence(const std::vector<ObstacleReturn>& obstacles, const GroundSurface& ground,
                              const SweepView& view, const DropView& drops, const Robot::Body& body,
                              const Pose& X_map_sweep, double resolution_m) {
  SweepEvidence evidence;
  count_returns(evidence, obstacles, resolution_m);

  const Eigen::Vector3d& o = view.origin();
  const double range = view.max_range_m();
  const Cell low = CostMap::tile_of(cell_at(o.x() - range, o.y() - range, resolution_m));
  const Cell high = CostMap::tile_of(cell_at(o.x() + range, o.y() + range, resolution_m));
  std::vector<Cell> tiles;
  for (std::int32_t y = low.y; y <= high.y; ++y) {
    for (std::int32_t x = low.x; x <= high.x; ++x) tiles.push_back({x, y});
  }
  // Tiles that gain something are kept; the map itself is only touched after the loop, in order.
  std::vector<std::unique_ptr<EvidenceTile>> seen(tiles.size());
  for_blocks(tiles.size(), 16, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t i = begin; i < end; ++i) {
      const double side = CostTile::kSide * resolution_m, x = tiles[i].x * side, y = tiles[i].y * side;
      const double dx = x + side / 2 - o.x(), dy = y + side / 2 - o.y();
      const bool near = dx * dx + dy * dy < SweepView::kMissingRange * SweepView::kMissingRange;
      if (!near && !ground.carries_within(x, y, x + side, y + side)) continue;
      auto tile = std::make_unique<EvidenceTile>();
      if (look_at_ground(tiles[i], *tile, ground, view, drops, resolution_m)) seen[i] = std::move(tile);
    }
  });
  for (std::size_t i = 0; i < tiles.size(); ++i) {
    if (seen[i] == nullptr) continue;
    lay_under(evidence[tiles[i]], *seen[i]);
  }
  doubt_spots(evidence, o, view.config(), resolution_m);
  stand(evidence, body, X_map_sweep, resolution_m);
  return evidence;
}

}  // namespace scanway
