#pragma once

#include <cstdint>
#include <set>
#include <vector>

#include "common/grid/bounds.h"
#include "common/grid/cost_map.h"
#include "common/robot/robot.h"
#include "modules/planner/core/body/bit_grid.h"
#include "modules/planner/core/body/body.h"
#include "modules/planner/core/body/cell_word.h"
#include "modules/planner/core/body/disc_dilation.h"

namespace scanway::planning {

/// What the robot is taken for.
enum class BodyMode {
  point,      ///< Occupied cells block; costs are ignored.
  paper,      ///< Occupied cells block; the accumulated cost of the paper weighs.
  footprint,  ///< The footprint must be clear at every heading; cost weighs.
};

struct TerrainOptions {
  BodyMode mode = BodyMode::footprint;
  UnknownPolicy unknown = UnknownPolicy::never;
  double unknown_price = 4.0;
  double clearance_weight = 3.0;
};

/// Where the body can be, and what a metre costs there: the cost map as the search sees it. Made for a cell when
/// the search first asks for it.
class Terrain {
 public:
  enum class Class : std::uint8_t {
    unasked = 0,
    blocked = 1,  ///< The centre cannot be here at any heading.
    tight = 2,    ///< At some headings perhaps; see headings().
    roomy = 3,    ///< At every heading, and turning is free.
  };

  /// `bounds` is where the robot's centre may be.
  Terrain(const CostMap& map, const CellRectangle& bounds, const Body& body, const TerrainOptions& options);

  /// Takes over what changed in `tiles` (by tile index). Returns the cells, by index and in order, whose class, weight
  /// or room may have changed; nothing for cells that nobody asked for. All tiles must lie within the frame.
  std::vector<std::uint32_t> update(const CostMap& map, const std::vector<Cell>& tiles);
  /// Widens the bounds to hold `bounds` too. Returns false where that changes what cells are, and nothing is done then.
  bool grow(const CellRectangle& bounds);
  /// Whether the frame has room for a tile.
  bool holds_tile(Cell tile) const;
  const std::set<Cell>& tiles() const { return tiles_; }

  const Frame& frame() const { return frame_; }
  const CellRectangle& bounds() const { return bounds_; }
  const TerrainOptions& options() const { return options_; }
  const Body& body() const { return *body_; }

  /// Class and weight of a cell in one word.
  std::uint16_t field(std::uint32_t index) {
    const std::uint16_t field = cells_[index].field();
    return (field >> kClassShift) != 0 ? field : ask(index);
  }
  /// The cell's word: its field is the terrain's, its value and tag belong to the search.
  CellWord& word(std::uint32_t index) { return cells_[index]; }
  const CellWord& word(std::uint32_t index) const { return cells_[index]; }
  /// Clears value and tag of all cells.
  void forget_search();
  static Class class_of(std::uint16_t field) { return static_cast<Class>(field >> kClassShift); }
  /// What a metre costs here, in units of 1 / weight_one().
  static std::uint32_t weight_of(std::uint16_t field) { return field & kWeightMask; }
  std::uint32_t weight_one() const { return weight_one_; }

  /// A number for every tight cell that anybody asked for, from 0 on.
  std::uint32_t slot(std::uint32_t index);
  /// The same plus 1; 0 when the cell has none.
  std::uint32_t known_slot(std::uint32_t index) const { return tight_.empty() ? 0 : slots_[index]; }
  std::uint32_t cell_of_slot(std::uint32_t slot) const { return tight_[slot].index; }
  std::size_t slots() const { return tight_.size(); }
  /// Bit k: the body has room at heading k.
  std::uint16_t headings(std::uint32_t slot) const { return tight_[slot].headings; }
  bool can_turn(std::uint32_t index, int heading) const { return is_clear(body_->turning(heading), index); }
  bool can_step(std::uint32_t index, int heading, int step) const {
    const Spans& spans = body_->stepping(heading, step);
    return spans.empty() || is_clear(spans, index);
  }
  /// Whether no cell that blocks is among `spans` about the cell.
  bool is_clear(const Spans& spans, std::uint32_t index) const;

  bool is_occupied(Cell cell) const { return frame_.contains(cell) && bit(occupied_, cell); }
  bool is_unknown(Cell cell) const { return !frame_.contains(cell) || !(bit(occupied_, cell) || bit(free_, cell)); }
  /// Occupied, or unknown where the policy says never.
  bool blocks(Cell cell) const { return !frame_.contains(cell) || bit(blocked_, cell); }
  const BitGrid& occupied() const { return occupied_; }

  static constexpr int kClassShift = 14;
  static constexpr std::uint16_t kWeightMask = (1u << kClassShift) - 1;

 private:
  struct TightCell {
    std::uint32_t index;
    std::uint16_t headings;
  };
  struct Changes {
    std::vector<std::uint32_t> weights;  ///< Cells that someone asked for, with another weight now.
    std::vector<std::uint32_t> blocked;  ///< Cells that block now, or do so no more.
  };

  bool bit(const BitGrid& grid, Cell cell) const { return grid.test(cell.x - frame_.low.x, cell.y - frame_.low.y); }
  std::uint16_t weight(CellState state, std::uint32_t cost) const;
  std::uint16_t ask(std::uint32_t index);
  void name_block(std::uint32_t first);
  void classify(std::int32_t row, std::int32_t column, Block& blocked, Block& roomy) const;
  void load(const CostMap& map, Cell tile, Changes& changes);
  void load_word(const CellState* states, const std::uint32_t* costs, std::int32_t y, std::int32_t x, Changes& changes);
  void reclassify_block(std::uint32_t first, std::vector<std::uint32_t>& changed);
  void reclassify_near(const std::vector<std::uint32_t>& cells, std::vector<std::uint32_t>& changed);
  std::uint16_t find_headings(std::uint32_t index) const;

  TerrainOptions options_;
  const Body* body_;
  CellRectangle bounds_;
  DiscDilation discs_;
  Frame frame_;
  std::uint32_t weight_one_;
  std::uint16_t unseen_weight_ = 0, seen_weight_ = 0;  ///< Of a cell that costs nothing.
  std::set<Cell> tiles_;
  BitGrid occupied_;
  BitGrid free_;
  BitGrid blocked_;
  LazyArray<CellWord> cells_;
  std::vector<std::uint32_t> asked_;  ///< The first cell of every block that anybody asked for.
  LazyArray<std::uint32_t> slots_;
  std::vector<TightCell> tight_;
};

}  // namespace scanway::planning
