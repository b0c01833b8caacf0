#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "common/grid/cost_map.h"
#include "modules/simulator/core/truth/truth_grid.h"
#include "modules/tools/compare/cells/seen_ground.h"

namespace scanway::tools {

/// What became of the cells of one kind.
struct CellCounts {
  // In truth free, and looked at.
  std::int64_t free = 0;
  std::int64_t free_called_occupied = 0;
  std::int64_t free_called_unknown = 0;
  // In truth occupied, with ground that was seen beside it.
  std::int64_t occupied = 0;
  std::int64_t occupied_called_free = 0;
  std::int64_t occupied_unmarked = 0;  ///< Of these, with no occupied cell of the map within kMarkReach_m.
  // In truth the upper edge of a drop, and looked at.
  std::int64_t drop_offs = 0;
  std::int64_t drop_offs_unmarked = 0;  ///< With no occupied cell of the map within kMarkReach_m.
  std::int64_t drop_offs_open = 0;      ///< Of these, the cells called free.

  std::int64_t free_lost() const { return free_called_occupied + free_called_unknown; }
  CellCounts& operator+=(const CellCounts& other);
  bool operator==(const CellCounts&) const = default;
};

/// A thing that the map has so near its true place is marked, though not to the cell.
constexpr double kMarkReach_m = 0.03;

struct MapComparison {
  CellCounts one, two;      ///< Cells whose ground one sweep saw; two or more.
  std::int64_t unseen = 0;  ///< Cells of the truth that have no ground point of any sweep near them,
  std::int64_t unseen_called_free = 0;

  MapComparison& operator+=(const MapComparison& other);
};

/// A cost map against the truth, cell by cell of the truth: each takes the state of the map's cell in which its centre
/// lies. `truth` and `seen` have the same resolution; `X_map_world`: as the robot's first place has it.
MapComparison compare(const CostMap& map, const Pose& X_map_world, const simulator::TruthGrid& truth,
                      const SeenGround& seen);

/// The cells of the truth (by their index in seen's window) that are free, that two sweeps or more looked at, and that
/// the map does not call free.
std::vector<std::size_t> lost_cells(const CostMap& map, const Pose& X_map_world, const simulator::TruthGrid& truth,
                                    const SeenGround& seen);

}  // namespace scanway::tools
