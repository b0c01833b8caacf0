#pragma once

#include <cstdint>
#include <cstring>

#include "modules/planner/core/body/terrain.h"

namespace scanway::planning {

/// The eight cells around a roomy one that lies inside its block (Frame::is_inner), looked at all together: most of the
/// search's time goes by here. By step, as bits.
struct Surroundings {
  unsigned roomy;   ///< What is there is roomy.
  unsigned better;  ///< A step from here costs less than the value there.
  bool simple;      ///< All nine are roomy or blocked. If not, the rest means nothing.
};

/// From an inner cell to its neighbour, by step.
constexpr std::array<std::int32_t, kSteps> kInnerStep = {
    Frame::inner_step(1, 0),  Frame::inner_step(1, 1),   Frame::inner_step(0, 1),  Frame::inner_step(-1, 1),
    Frame::inner_step(-1, 0), Frame::inner_step(-1, -1), Frame::inner_step(0, -1), Frame::inner_step(1, -1)};

namespace lanes {

/// Three neighbours in a row; the fourth lane is of no use.
using Row = std::uint64_t __attribute__((vector_size(32)));
using Signed = std::int64_t __attribute__((vector_size(32)));
using Halves = std::uint32_t __attribute__((vector_size(32)));

/// The steps of the lanes, as bits: the row below, the cell's own, the row above.
constexpr Row kSteps[3] = {{1 << 5, 1 << 6, 1 << 7, 0}, {1 << 4, 0, 1 << 0, 0}, {1 << 3, 1 << 2, 1 << 1, 0}};
constexpr int kRoomyShift = 8;

}  // namespace lanes

/// Costs of the steps between cells of weight 1/2, lane by lane: for the rows below and above, and for the cell's own.
struct UnitRows {
  lanes::Row beside;
  lanes::Row own;
};
inline UnitRows unit_rows(std::uint32_t straight, std::uint32_t diagonal) {
  const std::uint64_t s = straight, d = diagonal;
  return {lanes::Row{d, s, d, 0}, lanes::Row{s, 0, s, 0}};
}

[[gnu::always_inline]] inline Surroundings look_around(const CellWord* cell, const UnitRows& units) {
  using lanes::Row, lanes::Signed, lanes::Halves;
  const std::uint64_t weight = cell->field() & Terrain::kWeightMask;
  const std::uint64_t value = cell->value();
  Row all = ~Row{};
  Row found = {};
#pragma GCC unroll 3
  for (int y = -1; y <= 1; ++y) {
    Row words;
    std::memcpy(&words, cell + Frame::inner_step(-1, y), sizeof(words));
    all &= words;
    // Weights have 14 bits and units 13, so the product fits in the lower half of a lane.
    const Row weights = ((words >> CellWord::kFieldShift) & Terrain::kWeightMask) + weight;
    const Row costs = Row(Halves(weights) * Halves(y == 0 ? units.own : units.beside)) + value;
    const Row better = Row(Signed(~words >> CellWord::kValueShift) > Signed(costs));
    // Of the two bits of the class, roomy and tight have the upper one.
    const Row roomy = Row(Signed(words << (63 - Terrain::kClassShift - CellWord::kFieldShift - 1)) < 0);
    found |= (better & lanes::kSteps[y + 1]) | (roomy & (lanes::kSteps[y + 1] << lanes::kRoomyShift));
  }
  const std::uint64_t steps = found[0] | found[1] | found[2];
  // Roomy and blocked have the lower one.
  const std::uint64_t odd = all[0] & all[1] & all[2] & (cell->bits >> 1);
  return {static_cast<unsigned>(steps >> lanes::kRoomyShift), static_cast<unsigned>(steps & 0xFF),
          ((odd >> (Terrain::kClassShift + CellWord::kFieldShift)) & 1) != 0};
}

}  // namespace scanway::planning
