#pragma once

// The edges of the graph: bodies of Graph's templates.

#include "modules/planner/core/search/graph.h"

namespace scanway::planning {

template <bool kBelow, class Visit>
void Graph::edges(Node node, Visit&& visit) {
  if (is_tight(node)) {
    edges_of_tight<kBelow>(node, visit);
  } else {
    edges_of_roomy<kBelow>(node, visit);
  }
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
      visit(next, cost, link_of(kBelow ? opposite(step) : step, kRoomyParent));
      continue;
    }
    const std::uint32_t slot = terrain_->slot(next);
    const std::uint16_t headings = terrain_->headings(slot);
    for (int k = 0; headings != 0 && k < kMatches; ++k) {
      const int heading = match(travel<kBelow>(step), k);
      if (((headings >> heading) & 1) == 0 || !terrain_->can_step(node, heading, step)) continue;
      const Link how = kBelow ? link_of(opposite(step), kRoomyParent)
                              : link_of(step, static_cast<unsigned>(match_of(step, heading)) + 1);
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
            kBelow ? link_of(back, static_cast<unsigned>(match_of(back, heading)) + 1) : link_of(step, kRoomyParent));
      continue;
    }
    const std::uint32_t next_slot = terrain_->slot(next);
    if (((terrain_->headings(next_slot) >> heading) & 1) == 0) continue;
    visit(tight_node(next_slot, heading), cost, link_of(kBelow ? opposite(step) : step, kSameHeading));
  }
  const std::uint64_t turn = move_cost(0, here, here);
  const int above = (heading + 1) & (kHeadings - 1);
  const int below = (heading - 1) & (kHeadings - 1);
  if (((headings >> above) & 1) != 0 && terrain_->can_turn(index, heading)) {
    visit(tight_node(slot, above), turn, link_of(0, kBelow ? kTurnFromBelow : kTurnFromAbove));
  }
  if (((headings >> below) & 1) != 0 && terrain_->can_turn(index, below)) {
    visit(tight_node(slot, below), turn, link_of(0, kBelow ? kTurnFromAbove : kTurnFromBelow));
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
      visit(next, link_of(back, kRoomyParent));
      for (int heading = 0; slot != 0 && heading < kHeadings; ++heading) {
        visit(tight_node(slot - 1, heading), link_of(back, kRoomyParent));
      }
      continue;
    }
    const int k = match_of(back, heading_of(node));
    if (k < 0) continue;
    visit(next, link_of(back, static_cast<unsigned>(k) + 1));
    if (slot != 0) visit(tight_node(slot - 1, heading_of(node)), link_of(back, kSameHeading));
  }
  if (!is_tight(node)) return;
  const std::uint32_t slot = (node - cells_) / kHeadings;
  visit(tight_node(slot, heading_of(node) + 1), link_of(0, kTurnFromBelow));
  visit(tight_node(slot, heading_of(node) - 1), link_of(0, kTurnFromAbove));
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
