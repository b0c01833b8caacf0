#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "modules/planner/core/body/terrain.h"
#include "modules/planner/core/search/link.h"
#include "modules/planner/core/search/surroundings.h"

namespace scanway::planning {

/// Which end of the path the search tree has its root at.
enum class Root { goal, start };

/// The graph of the body's places. A roomy cell is one node, as turning there is free; a tight cell is a node for each
/// heading that has room. The robot drives forwards or, at twice the price, backwards, with its heading within 22.5
/// degrees of the step; it turns in place from heading to heading.
class Graph {
 public:
  /// Costs of a straight and of a diagonal step between cells of weight 1/2: integers in a ratio near sqrt(2).
  struct Units {
    std::uint32_t straight;
    std::uint32_t diagonal;
  };
  /// sqrt(2) to 1.1e-8: 0.01 of a cell in 900,000 diagonal steps.
  static constexpr Units kFine = {5741, 8119};
  /// sqrt(2) to 7.2e-5: for ways that cost more than 40 bits hold in the above.
  static constexpr Units kCoarse = {99, 140};

  Graph(Terrain& terrain, Root root, const Units& units);

  Terrain& terrain() const { return *terrain_; }
  Root root() const { return root_; }
  /// What a straight step costs between cells of weight one.
  std::uint64_t straight() const { return std::uint64_t{2} * units_[0] * terrain_->weight_one(); }
  /// Never more than the cost of any way between cells that are (dx, dy) apart.
  std::uint64_t least_cost(std::int32_t dx, std::int32_t dy) const {
    const auto x = static_cast<std::uint64_t>(dx < 0 ? -dx : dx);
    const auto y = static_cast<std::uint64_t>(dy < 0 ? -dy : dy);
    return x > y ? x * least_straight_ + y * least_diagonal_rise_ : y * least_straight_ + x * least_diagonal_rise_;
  }

  bool is_tight(Node node) const { return node >= cells_; }
  std::uint32_t index_of(Node node) const {
    return is_tight(node) ? terrain_->cell_of_slot((node - cells_) / kHeadings) : node;
  }
  Cell cell_of(Node node) const { return terrain_->frame().cell(index_of(node)); }
  int heading_of(Node node) const { return static_cast<int>((node - cells_) % kHeadings); }
  Node tight_node(std::uint32_t slot, int heading) const {
    return cells_ + slot * kHeadings + static_cast<std::uint32_t>(heading & (kHeadings - 1));
  }
  /// The node that `node` hangs on by `link`.
  Node parent(Node node, Link link) const;

  /// The steps from a roomy cell inside its block to roomy ones, as bits; nothing when it or a cell beside it is
  /// anything but roomy or blocked, or nobody has asked for it yet.
  [[gnu::always_inline]] std::optional<unsigned> open_steps(Node node) const {
    if (is_tight(node) || !Frame::is_inner(node)) return std::nullopt;
    const Surroundings around = look_around(&terrain_->word(node), unit_rows_);
    if (!around.simple) return std::nullopt;
    return around.roomy & allowed(around.roomy);
  }
  /// Of these, the ones that cost less than the value there.
  [[gnu::always_inline]] std::optional<unsigned> gaining_steps(Node node) const {
    if (is_tight(node) || !Frame::is_inner(node)) return std::nullopt;
    const Surroundings around = look_around(&terrain_->word(node), unit_rows_);
    if (!around.simple) return std::nullopt;
    return around.better & around.roomy & allowed(around.roomy);
  }
  /// The cost of one of these.
  std::uint64_t cost_of_step(const CellWord* cell, int step) const {
    return move_cost(step, cell->field(), cell[kInnerStep[static_cast<std::size_t>(step)]].field());
  }
  static Link link_to_roomy_parent(int step_from_parent) { return link_of(opposite(step_from_parent), kRoomyParent); }
  /// Never less than any one step between roomy cells costs.
  std::uint64_t dearest_step() const { return std::uint64_t{2} * units_[1] * Terrain::kWeightMask; }
  /// Fetches what expanding a node will look at.
  void prefetch(Node node) const {
    // Without it the compiler takes this for a function without effect and leaves out its calls.
    asm volatile("");
    if (is_tight(node)) return;
    const CellWord* const cell = &terrain_->word(node);
    for (const int step : {0, 1, 3, 4, 5, 7}) __builtin_prefetch(cell + kInnerStep[static_cast<std::size_t>(step)]);
  }

  /// Calls visit(neighbour, cost, link of the neighbour if it hangs on `node`) for every edge; the cost is that of
  /// travelling towards the root through `node` (away from it when the root is the start).
  template <class Visit>
  void edges_below(Node node, Visit&& visit) {
    edges<true>(node, visit);
  }
  /// Calls visit(neighbour, cost, link of `node` if it hangs on the neighbour).
  template <class Visit>
  void edges_above(Node node, Visit&& visit) {
    edges<false>(node, visit);
  }
  /// Calls visit(neighbour, link) for all nodes that might hang on `node`, whatever blocks the way now.
  template <class Visit>
  void possible_children(Node node, Visit&& visit) const;
  /// The cost of the edge from `child` to the parent that it hangs on by `link`; nothing when there is none (any more).
  std::optional<std::uint64_t> cost_above(Node child, Link link);
  /// Calls visit(node) for the nodes that a cell has now.
  template <class Visit>
  void nodes_of(std::uint32_t index, Visit&& visit);
  /// The same for all that it may ever have had.
  template <class Visit>
  void possible_nodes_of(std::uint32_t index, Visit&& visit) const;

 private:
  std::uint64_t move_cost(int step, std::uint16_t a, std::uint16_t b) const {
    return std::uint64_t{units_[step & 1]} * (Terrain::weight_of(a) + Terrain::weight_of(b));
  }
  static std::uint64_t if_backwards(int match, std::uint64_t cost) { return match >= 3 ? 2 * cost : cost; }
  /// The steps that cut no corner, where corners block.
  unsigned allowed(unsigned roomy) const { return corners_block_ ? kStraightSteps | beside_on_both_sides(roomy) : ~0u; }
  static constexpr unsigned kStraightSteps = 0x55;
  /// The diagonal steps whose two straight neighbours are both among `steps` (bit k: step k).
  static unsigned beside_on_both_sides(unsigned steps) {
    const unsigned straight = steps & kStraightSteps;
    return straight << 1 & (straight >> 1 | straight << 7);
  }
  Node neighbour(std::uint32_t index, int step) const {
    const auto at = static_cast<std::size_t>(step);
    return terrain_->frame().beside(index, kStepX[at], kStepY[at]);
  }

  std::optional<std::uint64_t> cost_between_roomy(Node from, int step);
  template <bool kBelow, class Visit>
  void edges(Node node, Visit&& visit);
  template <bool kBelow, class Visit>
  void edges_of_roomy(Node node, Visit&& visit);
  template <bool kBelow, class Visit>
  void edges_of_tight(Node node, Visit&& visit);
  /// Whether the robot travels from the child to the parent along `step`, or against it.
  template <bool kBelow>
  int travel(int step) const {
    // The step leads from the node asked about to its neighbour: from parent to child below, from child to parent
    // above.
    const bool with = kBelow == (root_ == Root::start);
    return with ? step : opposite(step);
  }

  Terrain* terrain_;
  Root root_;
  Node cells_;
  bool corners_block_;
  std::array<std::uint32_t, 2> units_;
  UnitRows unit_rows_;
  std::uint64_t least_straight_;
  std::uint64_t least_diagonal_rise_;
};

}  // namespace scanway::planning
