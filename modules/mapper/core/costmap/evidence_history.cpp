#include "modules/mapper/core/costmap/evidence_history.h"

namespace scanway {
namespace {

using Plane = std::array<std::uint8_t, CostTile::kCells>;

constexpr std::size_t kSide = CostTile::kSide;
constexpr std::size_t kLongestRun = 256;

void pack(const Plane& plane, std::vector<std::uint8_t>& runs) {
  const auto difference = [&](std::size_t cell) {
    return static_cast<std::uint8_t>(plane[cell] ^ (cell < kSide ? 0 : plane[cell - kSide]));
  };
  for (std::size_t begin = 0, end = 0; begin < plane.size(); begin = end) {
    while (end < plane.size() && end - begin < kLongestRun && difference(end) == difference(begin)) ++end;
    runs.push_back(static_cast<std::uint8_t>(end - begin - 1));
    runs.push_back(difference(begin));
  }
}

/// Returns where the plane's runs end.
const std::uint8_t* unpack(const std::uint8_t* runs, Plane& plane) {
  for (std::size_t cell = 0; cell < plane.size(); runs += 2) {
    for (const std::size_t end = cell + runs[0] + 1; cell < end; ++cell) {
      plane[cell] = static_cast<std::uint8_t>(runs[1] ^ (cell < kSide ? 0 : plane[cell - kSide]));
    }
  }
  return runs;
}

/// Where the evidence has a view, it wins. Whether any state changed.
bool overlay(const EvidenceTile& evidence, std::array<Known, CostTile::kCells>& known, CostTile& tile) {
  bool changed = false;
  for (std::size_t cell = 0; cell < CostTile::kCells; ++cell) {
    known[cell] = evidence.over(known[cell], cell);
    const CellState state = state_of(known[cell]);
    changed = changed || state != tile.state[cell];
    tile.state[cell] = state;
  }
  return changed;
}

bool says_anything(const EvidenceTile& evidence) {
  for (std::size_t cell = 0; cell < CostTile::kCells; ++cell) {
    if (evidence.says_anything(cell)) return true;
  }
  return false;
}

}  // namespace

PackedEvidence::PackedEvidence(const EvidenceTile& tile) {
  pack(tile.returns, runs_);
  pack(tile.beams, runs_);
  pack(tile.ground, runs_);
  runs_.shrink_to_fit();
}

EvidenceTile PackedEvidence::unpacked() const {
  EvidenceTile tile;
  const std::uint8_t* runs = unpack(runs_.data(), tile.returns);
  runs = unpack(runs, tile.beams);
  unpack(runs, tile.ground);
  return tile;
}

std::vector<Cell> EvidenceHistory::put(CostMap& map, SweepNumber sweep, const SweepEvidence& evidence) {
  forget(sweep);
  std::set<Cell> changed;
  for (const auto& [index, tile] : evidence) {
    if (!says_anything(tile)) continue;
    TileHistory& history = tiles_[index];
    const bool newest = history.sweeps.empty() || history.sweeps.rbegin()->first < sweep;
    history.sweeps.emplace(sweep, tile);
    if (!newest || unsettled_.contains(index)) {
      unsettled_.insert(index);
    } else if (overlay(tile, history.known, map.tiles[index])) {
      changed.insert(index);
    }
  }
  for (const Cell& index : settle(map)) changed.insert(index);
  return {changed.begin(), changed.end()};
}

std::vector<Cell> EvidenceHistory::withdraw(CostMap& map, SweepNumber sweep) {
  forget(sweep);
  return settle(map);
}

void EvidenceHistory::hold(SweepNumber sweep, const SweepEvidence& evidence) {
  forget(sweep);
  for (const auto& [index, tile] : evidence) {
    if (!says_anything(tile)) continue;
    tiles_[index].sweeps.emplace(sweep, tile);
    unsettled_.insert(index);
  }
}

void EvidenceHistory::forget(SweepNumber sweep) {
  for (auto tile = tiles_.begin(); tile != tiles_.end();) {
    if (tile->second.sweeps.erase(sweep) > 0) unsettled_.insert(tile->first);
    tile = tile->second.sweeps.empty() ? tiles_.erase(tile) : std::next(tile);
  }
}

std::vector<Cell> EvidenceHistory::settle(CostMap& map) {
  std::vector<Cell> changed;
  for (const Cell& index : unsettled_) {
    if (project(map, index)) changed.push_back(index);
  }
  unsettled_.clear();
  return changed;
}

bool EvidenceHistory::project(CostMap& map, Cell index) {
  CostTile& tile = map.tiles[index];
  const auto before = tile.state;
  tile.state.fill(CellState::unknown);
  if (const auto found = tiles_.find(index); found != tiles_.end()) {
    TileHistory& history = found->second;
    history.known.fill(Known::nothing);
    for (const auto& [sweep, packed] : history.sweeps) overlay(packed.unpacked(), history.known, tile);
  }
  return tile.state != before;
}

std::size_t EvidenceHistory::bytes() const {
  std::size_t bytes = 0;
  for (const auto& [index, history] : tiles_) {
    for (const auto& [sweep, packed] : history.sweeps) bytes += packed.bytes();
  }
  return bytes;
}

}  // namespace scanway
