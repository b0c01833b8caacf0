#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "modules/planner/core/body/terrain.h"

namespace scanway::planning {

/// A place of the body: a roomy cell by its index, or a tight cell at one heading, numbered from the frame's size on.
using Node = std::uint32_t;

/// How a node hangs on its parent, in six bits: the step to the parent's cell, and which of its nodes it is.
using Link = std::uint8_t;
constexpr Link kLinkMask = 0x3F;

/// Which end of the path the search tree has its root at.
enum class Root { goal, start };

/// The graph of the body's places. A roomy cell is one node, as turning there is free; a tight cell is a node for each
/// heading that has room. The robot drives forwards or, at twice the price, backwards, with its heading within 22.5
/// degrees of the step; it turns in place from heading to heading.
class Graph {
 public:
  /// Costs of a straight and of a diagonal step between cells of weight 1/2: integers in a ratio near sqrt(2).
  struct Units {
    std::uint64_t straight;
    std::uint64_t diagonal;
  };
  /// sqrt(2) to 1.1e-8: 0.01 of a cell in 900,000 diagonal steps.
  static constexpr Units kFine = {5741, 8119};
  /// sqrt(2) to 7.2e-5: for ways that cost more than 40 bits hold in the above.
  static constexpr Units kCoarse = {99, 140};

  Graph(Terrain& terrain, Root root, const Units& units);

  Terrain& terrain() const { return *terrain_; }
  Root root() const { return root_; }
  /// What a straight step costs between cells of weight one.
  std::uint64_t straight() const { return 2 * units_[0] * terrain_->weight_one(); }
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
  /// The same as the frame's cell(), without its division.
  Cell cell_of(Node node) const {
    const std::uint32_t index = index_of(node);
    const auto y = static_cast<std::uint32_t>(static_cast<unsigned __int128>(index) * row_reciprocal_ >> 64);
    const Frame& frame = terrain_->frame();
    return {frame.low.x + static_cast<std::int32_t>(index - y * static_cast<std::uint32_t>(frame.width)),
            frame.low.y + static_cast<std::int32_t>(y)};
  }
  int heading_of(Node node) const { return static_cast<int>((node - cells_) % kHeadings); }
  Node tight_node(std::uint32_t slot, int heading) const {
    return cells_ + slot * kHeadings + static_cast<std::uint32_t>(heading & (kHeadings - 1));
  }
  /// The node that `node` hangs on by `link`.
  Node parent(Node node, Link link) const;

  /// The eight cells around a roomy one, by step.
  struct Surroundings {
    std::array<Node, kSteps> node;
    std::array<std::uint64_t, kSteps> cost;  ///< Of the step; whatever where there is none.
    unsigned open;                           ///< Bit k: step k leads somewhere.
  };
  /// Returns false when the cell or one of the eight is anything but roomy or blocked.
  bool surroundings(Node cell, Surroundings& around);
  static Link link_to_roomy_parent(std::size_t step_from_parent) {
    return link(opposite(static_cast<int>(step_from_parent)), kRoomyParent);
  }
  /// Never less than any one step between roomy cells costs.
  std::uint64_t dearest_step() const { return units_[1] * 2 * Terrain::kWeightMask; }
  void prefetch(Node node) const {
    if (is_tight(node)) return;
    __builtin_prefetch(&terrain_->word(neighbour(node, 2)));
    __builtin_prefetch(&terrain_->word(node));
    __builtin_prefetch(&terrain_->word(neighbour(node, 6)));
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
  enum Code : unsigned { kRoomyParent = 0, kSameHeading = 1, kTurnFromBelow = 2, kTurnFromAbove = 3 };
  static constexpr int kMatches = 6;  ///< Headings that go with a step: three forwards, three backwards.

  static Link link(int step_to_parent, unsigned code) {
    return static_cast<Link>(static_cast<unsigned>(step_to_parent) | code << 3);
  }
  static int match(int step, int k) { return (2 * step + k % 3 - 1 + 8 * (k / 3)) & (kHeadings - 1); }
  /// The inverse of match(); -1 when the heading does not go with the step.
  static int match_of(int step, int heading) {
    static constexpr std::array<std::int8_t, kHeadings> kMatch = {1, 2, -1, -1, -1, -1, -1, 3,
                                                                  4, 5, -1, -1, -1, -1, -1, 0};
    return kMatch[static_cast<std::size_t>((heading - 2 * step) & (kHeadings - 1))];
  }
  std::uint64_t move_cost(int step, std::uint16_t a, std::uint16_t b) const {
    return units_[step & 1] * (Terrain::weight_of(a) + Terrain::weight_of(b));
  }
  static std::uint64_t if_backwards(int match, std::uint64_t cost) { return match >= 3 ? 2 * cost : cost; }
  static constexpr unsigned kStraightSteps = 0x55;
  /// The diagonal steps whose two straight neighbours are both among `steps` (bit k: step k).
  static unsigned beside_on_both_sides(unsigned steps) {
    const unsigned straight = steps & kStraightSteps;
    return straight << 1 & (straight >> 1 | straight << 7);
  }
  Node neighbour(std::uint32_t index, int step) const {
    return index + static_cast<std::uint32_t>(offset_[static_cast<std::size_t>(step)]);
  }

  template <bool kBelow, class Visit>
  void edges(Node node, Visit&& visit) {
    if (is_tight(node)) {
      edges_of_tight<kBelow>(node, visit);
    } else {
      edges_of_roomy<kBelow>(node, visit);
    }
  }
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
  std::array<std::uint64_t, 2> units_;
  std::uint64_t row_reciprocal_;  ///< 2^64 / width, rounded up: exact for 32-bit indices.
  std::uint64_t least_straight_;
  std::uint64_t least_diagonal_rise_;
  std::array<std::int32_t, kSteps> offset_;
};

inline bool Graph::surroundings(Node cell, Surroundings& around) {
  const std::uint16_t here = terrain_->field(cell);
  unsigned open = 0;
  unsigned simple = unsigned{Terrain::class_of(here) == Terrain::Class::roomy};
  for (unsigned step = 0; step < kSteps; ++step) {
    around.node[step] = neighbour(cell, static_cast<int>(step));
    const std::uint16_t there = terrain_->field(around.node[step]);
    const Terrain::Class what = Terrain::class_of(there);
    open |= unsigned{what == Terrain::Class::roomy} << step;
    simple &= unsigned{what != Terrain::Class::tight};
    around.cost[step] = move_cost(static_cast<int>(step), here, there);
  }
  if (corners_block_) open &= kStraightSteps | beside_on_both_sides(open);
  around.open = open;
  return simple != 0;
}

template <bool kBelow, class Visit>
void Graph::edges_of_roomy(Node node, Visit&& visit) {
  const std::uint16_t here = terrain_->field(node);
  if (Terrain::class_of(here) != Terrain::Class::roomy) return;
  std::array<std::uint16_t, kSteps> fields;
  unsigned open = 0;
  for (unsigned step = 0; step < kSteps; ++step) {
    fields[step] = terrain_->field(neighbour(node, static_cast<int>(step)));
    open |= unsigned{Terrain::class_of(fields[step]) != Terrain::Class::blocked} << step;
  }
  if (corners_block_) open &= kStraightSteps | beside_on_both_sides(open);
  for (; open != 0; open &= open - 1) {
    const int step = __builtin_ctz(open);
    const std::uint16_t there = fields[static_cast<std::size_t>(step)];
    const Terrain::Class what = Terrain::class_of(there);
    const Node next = neighbour(node, step);
    const std::uint64_t cost = move_cost(step, here, there);
    if (what == Terrain::Class::roomy) {
      visit(next, cost, link(kBelow ? opposite(step) : step, kRoomyParent));
      continue;
    }
    const std::uint32_t slot = terrain_->slot(next);
    const std::uint16_t headings = terrain_->headings(slot);
    for (int k = 0; headings != 0 && k < kMatches; ++k) {
      const int heading = match(travel<kBelow>(step), k);
      if (((headings >> heading) & 1) == 0 || !terrain_->can_step(node, heading, step)) continue;
      const Link how =
          kBelow ? link(opposite(step), kRoomyParent) : link(step, static_cast<unsigned>(match_of(step, heading)) + 1);
      visit(tight_node(slot, heading), if_backwards(k, cost), how);
    }
  }
}

template <bool kBelow, class Visit>
void Graph::edges_of_tight(Node node, Visit&& visit) {
  const std::uint32_t slot = (node - cells_) / kHeadings;
  const std::uint32_t index = terrain_->cell_of_slot(slot);
  const int heading = heading_of(node);
  const std::uint16_t here = terrain_->field(index);
  const std::uint16_t headings = terrain_->headings(slot);
  if (Terrain::class_of(here) != Terrain::Class::tight || ((headings >> heading) & 1) == 0) return;
  for (int step = 0; step < kSteps; ++step) {
    const int k = match_of(travel<kBelow>(step), heading);
    if (k < 0) continue;
    const Node next = neighbour(index, step);
    const std::uint16_t there = terrain_->field(next);
    const Terrain::Class what = Terrain::class_of(there);
    if (what == Terrain::Class::blocked || !terrain_->can_step(index, heading, step)) continue;
    const std::uint64_t cost = if_backwards(k, move_cost(step, here, there));
    if (what == Terrain::Class::roomy) {
      const int back = opposite(step);
      visit(next, cost,
            kBelow ? link(back, static_cast<unsigned>(match_of(back, heading)) + 1) : link(step, kRoomyParent));
      continue;
    }
    const std::uint32_t next_slot = terrain_->slot(next);
    if (((terrain_->headings(next_slot) >> heading) & 1) == 0) continue;
    visit(tight_node(next_slot, heading), cost, link(kBelow ? opposite(step) : step, kSameHeading));
  }
  const std::uint64_t turn = units_[0] * 2 * Terrain::weight_of(here);
  const int above = (heading + 1) & (kHeadings - 1);
  const int below = (heading - 1) & (kHeadings - 1);
  if (((headings >> above) & 1) != 0 && terrain_->can_turn(index, heading)) {
    visit(tight_node(slot, above), turn, link(0, kBelow ? kTurnFromBelow : kTurnFromAbove));
  }
  if (((headings >> below) & 1) != 0 && terrain_->can_turn(index, below)) {
    visit(tight_node(slot, below), turn, link(0, kBelow ? kTurnFromAbove : kTurnFromBelow));
  }
}

template <class Visit>
void Graph::possible_children(Node node, Visit&& visit) const {
  const std::uint32_t index = index_of(node);
  for (int step = 0; step < kSteps; ++step) {
    const Node next = neighbour(index, step);
    const int back = opposite(step);
    const std::uint32_t slot = terrain_->known_slot(next);
    if (!is_tight(node)) {
      visit(next, link(back, kRoomyParent));
      for (int heading = 0; slot != 0 && heading < kHeadings; ++heading) {
        visit(tight_node(slot - 1, heading), link(back, kRoomyParent));
      }
      continue;
    }
    const int k = match_of(back, heading_of(node));
    if (k < 0) continue;
    visit(next, link(back, static_cast<unsigned>(k) + 1));
    if (slot != 0) visit(tight_node(slot - 1, heading_of(node)), link(back, kSameHeading));
  }
  if (!is_tight(node)) return;
  const std::uint32_t slot = (node - cells_) / kHeadings;
  visit(tight_node(slot, heading_of(node) + 1), link(0, kTurnFromBelow));
  visit(tight_node(slot, heading_of(node) - 1), link(0, kTurnFromAbove));
}

template <class Visit>
void Graph::nodes_of(std::uint32_t index, Visit&& visit) {
  const Terrain::Class what = Terrain::class_of(terrain_->field(index));
  if (what == Terrain::Class::roomy) visit(Node{index});
  if (what != Terrain::Class::tight) return;
  const std::uint32_t slot = terrain_->slot(index);
  for (int heading = 0; heading < kHeadings; ++heading) {
    if ((terrain_->headings(slot) >> heading) & 1) visit(tight_node(slot, heading));
  }
}

template <class Visit>
void Graph::possible_nodes_of(std::uint32_t index, Visit&& visit) const {
  visit(Node{index});
  const std::uint32_t slot = terrain_->known_slot(index);
  for (int heading = 0; slot != 0 && heading < kHeadings; ++heading) visit(tight_node(slot - 1, heading));
}

}  // namespace scanway::planning
