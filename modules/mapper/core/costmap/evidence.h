#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "common/geometry/pose.h"
#include "common/grid/cost_map.h"
#include "common/robot/robot.h"
#include "modules/mapper/core/costmap/drop_view.h"
#include "modules/mapper/core/costmap/obstacle_returns.h"
#include "modules/mapper/core/costmap/sweep_view.h"
#include "modules/mapper/core/ground/ground_surface.h"

namespace scanway {

/// What one sweep says of one tile's cells, in integers (each stays at 255 when it is more).
struct EvidenceTile {
  std::array<std::uint8_t, CostTile::kCells> returns{};  ///< Returns between the climbable step and the body's height.
  std::array<std::uint8_t, CostTile::kCells> beams{};    ///< One of the values below; 0: nothing passed.
  std::array<std::uint8_t, CostTile::kCells> ground{};   ///< Ground columns within 0.3 m that agree; 0: not carried.

  CellState state(std::size_t cell) const {
    if (returns[cell] > 0 || beams[cell] == kDrop || beams[cell] == kFarDrop) return CellState::occupied;
    return beams[cell] > 0 && ground[cell] > 0 ? CellState::free : CellState::unknown;
  }
  /// What is known of the cell when older sweeps had it as `before`. Air that was seen to be empty over ground of which
  /// this sweep knows nothing is no floor, but nothing stands there any more.
  CellState over(CellState before, std::size_t cell) const {
    const CellState seen = state(cell);
    if (seen == CellState::unknown) return empties(cell) && before == CellState::occupied ? seen : before;
    return yields(cell) && before != CellState::unknown ? before : seen;
  }
  bool says_anything(std::size_t cell) const { return state(cell) != CellState::unknown || empties(cell); }

  /// Beams passed and saw the air empty to the ground.
  static constexpr std::uint8_t kEmpty = 1;
  /// Beams passed below the body's height, over ground that the body hides from its own laser. Any older view counts
  /// for more.
  static constexpr std::uint8_t kOwnShadow = 2;
  /// Beams went down where the ground should go on.
  static constexpr std::uint8_t kDrop = 3;
  /// The same from so far that it may be a slope. Any older view counts for more.
  static constexpr std::uint8_t kFarDrop = 4;

 private:
  bool empties(std::size_t cell) const { return beams[cell] == kEmpty; }
  bool yields(std::size_t cell) const { return beams[cell] == kOwnShadow || beams[cell] == kFarDrop; }
};

/// One sweep's evidence, by tile index of the cost map.
using SweepEvidence = std::map<Cell, EvidenceTile>;

/// The evidence of a sweep, from its obstacle returns, its ground and what it saw. The cells under the robot's
/// footprint at X_map_sweep are free: the robot stands there, and no beam of its own can show it. Close around it,
/// where its body hides the ground, cells are free that nothing says more of: else no robot could leave its first
/// place.
SweepEvidence gather_evidence(const std::vector<ObstacleReturn>& obstacles, const GroundSurface& ground,
                              const SweepView& view, const DropView& drops, const Robot::Body& body,
                              const Pose& X_map_sweep, double resolution_m);

}  // namespace scanway
