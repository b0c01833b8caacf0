#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "common/geometry/pose.h"
#include "common/grid/cost_map.h"
#include "common/robot/robot.h"
#include "modules/mapper/core/costmap/obstacle_returns.h"
#include "modules/mapper/core/costmap/sweep_view.h"
#include "modules/mapper/core/ground/ground_surface.h"

namespace scanway {

/// What one sweep says of one tile's cells, in integers (each stays at 255 when it is more).
struct EvidenceTile {
  std::array<std::uint8_t, CostTile::kCells> returns{};  ///< Returns between the climbable step and the body's height.
  std::array<std::uint8_t, CostTile::kCells> beams{};    ///< 1 where beams passed and saw the air empty to the ground.
  std::array<std::uint8_t, CostTile::kCells> ground{};   ///< Ground columns within 0.3 m that agree; 0: not carried.

  CellState state(std::size_t cell) const {
    if (returns[cell] > 0) return CellState::occupied;
    return beams[cell] > 0 && ground[cell] > 0 ? CellState::free : CellState::unknown;
  }
  /// Whether what any older sweep saw of the cell counts for more.
  bool yields(std::size_t cell) const { return beams[cell] == kOwnShadow; }

  /// In place of 1: beams passed below the body's height, over ground that the body hides from its own laser.
  static constexpr std::uint8_t kOwnShadow = 2;
};

/// One sweep's evidence, by tile index of the cost map.
using SweepEvidence = std::map<Cell, EvidenceTile>;

/// The evidence of a sweep, from its obstacle returns, its ground and what it saw. The cells under the robot's
/// footprint at X_map_sweep are free: the robot stands there, and no beam of its own can show it. Close around it,
/// where its body hides the ground, cells are free that nothing says more of: else no robot could leave its first
/// place.
SweepEvidence gather_evidence(const std::vector<ObstacleReturn>& obstacles, const GroundSurface& ground,
                              const SweepView& view, const Robot::Body& body, const Pose& X_map_sweep,
                              double resolution_m);

/// Lays a sweep over the map: where it has a view, it wins over what was known before.
void apply_evidence(CostMap& map, const SweepEvidence& evidence);

}  // namespace scanway
