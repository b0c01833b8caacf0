#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <vector>

#include "common/grid/cost_map.h"
#include "modules/mapper/core/cloud/sweep_number.h"
#include "modules/mapper/core/costmap/evidence.h"

namespace scanway {

/// A tile of evidence in a few hundred bytes, without loss: of each quantity, runs of how a row differs from the one
/// before it.
class PackedEvidence {
 public:
  explicit PackedEvidence(const EvidenceTile& tile);
  EvidenceTile unpacked() const;
  std::size_t bytes() const { return runs_.size(); }

 private:
  std::vector<std::uint8_t> runs_;  ///< Pairs: how many cells less one, and their difference.
};

/// What every sweep says of the map's cells, each for itself, and the states that follow: of all sweeps with a view of
/// a cell, the newest has its say. A thing that stood there in an older sweep alone is so gone from the map, and any
/// sweep can be withdrawn or moved afterwards: the states are then those of a map that never had it there.
///
/// Each function brings the states of `map` up to date (nothing else may set them) and returns the tiles of which one
/// changed, in order: what embody() must look at.
class EvidenceHistory {
 public:
  /// Adds a sweep, or puts other evidence in the place of what it said before, as when its pose was corrected. It keeps
  /// its place among the others by its number, whenever it comes.
  std::vector<Cell> put(CostMap& map, SweepNumber sweep, const SweepEvidence& evidence);
  /// Nothing happens when there is no such sweep.
  std::vector<Cell> withdraw(CostMap& map, SweepNumber sweep);

  /// For many at once: these put and withdraw, and the states of `map` follow with settle().
  void hold(SweepNumber sweep, const SweepEvidence& evidence);
  void forget(SweepNumber sweep);
  std::vector<Cell> settle(CostMap& map);

  std::size_t bytes() const;  ///< Of all evidence, packed.

 private:
  struct TileHistory {
    std::map<SweepNumber, PackedEvidence> sweeps;  ///< Oldest first.
    std::array<Known, CostTile::kCells> known{};
  };

  /// Makes the states of a tile anew; whether any changed.
  bool project(CostMap& map, Cell index);

  std::map<Cell, TileHistory> tiles_;
  std::set<Cell> unsettled_;
};

}  // namespace scanway
