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

/// What is known of a cell from sweeps one after the other.
enum class Known : std::uint8_t {
  nothing = 0,
  suspected = 1,      ///< The ground may break off here. Only a sweep that sees it closely can call it free.
  sparsely_free = 2,  ///< Free between beams that lie far apart.
  free = 3,
  low = 4,  ///< Occupied by so low (or deep) a step that beams which lie far apart may miss it.
  occupied = 5,
};

inline CellState state_of(Known known) {
  if (known >= Known::low) return CellState::occupied;
  return known >= Known::sparsely_free ? CellState::free : CellState::unknown;
}

/// What one sweep says of one tile's cells, in integers (each stays at 255 when it is more).
struct EvidenceTile {
  std::array<std::uint8_t, CostTile::kCells> returns{};  ///< Returns between the climbable step and the body's height.
  std::array<std::uint8_t, CostTile::kCells> beams{};    ///< One of the values below; 0: nothing passed.
  std::array<std::uint8_t, CostTile::kCells> ground{};   ///< Ground columns within 0.3 m that agree; 0: not carried.

  /// Beams passed and saw the air empty to the ground. Over ground of which the sweep knows nothing that is no floor,
  /// but nothing stands there any more.
  static constexpr std::uint8_t kEmpty = 1;
  /// Beams passed below the body's height, over ground that the body hides from its own laser. Any older view counts
  /// for more.
  static constexpr std::uint8_t kOwnShadow = 2;
  /// Beams went down where the ground should go on.
  static constexpr std::uint8_t kDrop = 3;
  /// The same from so far that it may be a slope. Any older view from near by counts for more.
  static constexpr std::uint8_t kFarDrop = 4;
  /// The same, and not so deep that one may tell.
  static constexpr std::uint8_t kUnsure = 5;
  /// Beams passed and saw the air empty, but so far apart that a low step between them would not be seen.
  static constexpr std::uint8_t kSparse = 6;
  /// Where there are returns: from nothing but a low step.
  static constexpr std::uint8_t kLowStep = 7;

  /// What is known of the cell when older sweeps left it as `before`.
  Known over(Known before, std::size_t cell) const;
  /// What this sweep says by itself.
  CellState state(std::size_t cell) const { return state_of(over(Known::nothing, cell)); }
  bool says_anything(std::size_t cell) const { return returns[cell] > 0 || beams[cell] > 0; }
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
