#pragma once

#include <array>
#include <cstdint>

#include "common/grid/cost_map.h"
#include "modules/simulator/core/truth/truth_grid.h"
#include "modules/tools/compare/seen_ground.h"

namespace scanway::tools {

/// What became of the cells of one kind.
struct CellCounts {
  // In truth free, and looked at.
  std::int64_t free = 0;
  std::int64_t free_called_occupied = 0;
  std::int64_t free_called_unknown = 0;
  // In truth occupied or the edge of a drop, with ground that was seen beside it.
  std::int64_t occupied = 0;
  std::int64_t occupied_called_free = 0;
  std::int64_t occupied_unmarked = 0;  ///< Of these, with no occupied cell of the map within kMarkReach_m.

  std::int64_t free_lost() const { return free_called_occupied + free_called_unknown; }
  CellCounts& operator+=(const CellCounts& other);
  bool operator==(const CellCounts&) const = default;
};

/// A thing that the map has so near its true place is marked, though not to the cell.
constexpr double kMarkReach_m = 0.03;

struct MapComparison {
  CellCounts one, two;  ///< Cells whose ground one sweep saw; two or more.

  MapComparison& operator+=(const MapComparison& other);
};

/// A cost map against the truth, cell by cell of the truth: each takes the state of the map's cell in which its centre
/// lies. `truth` and `seen` have the same resolution; `X_map_world`: as the robot's first place has it.
MapComparison compare(const CostMap& map, const Pose& X_map_world, const simulator::TruthGrid& truth,
                      const SeenGround& seen);

}  // namespace scanway::tools
