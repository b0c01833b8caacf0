#include "modules/planner/core/search/graph_edges.h"

namespace scanway::planning {

Graph::Graph(Terrain& terrain, Root root, const Units& units)
    : terrain_(&terrain),
      root_(root),
      cells_(static_cast<Node>(terrain.frame().cells())),
      corners_block_(terrain.options().mode != BodyMode::footprint),
      units_({units.straight, units.diagonal}),
      unit_rows_(unit_rows(units.straight, units.diagonal)),
      least_straight_(straight()),
      least_diagonal_rise_(std::uint64_t{2} * (units.diagonal - units.straight) * terrain.weight_one()) {}

Node Graph::parent(Node node, Link link) const {
  const int step = link & 7;
  const unsigned code = link >> 3 & 7;
  const Node cell = neighbour(index_of(node), step);
  if (!is_tight(node)) {
    if (code == kRoomyParent) return cell;
    return tight_node(terrain_->known_slot(cell) - 1, match(step, static_cast<int>(code) - 1));
  }
  switch (code) {
    case kRoomyParent:
      return cell;
    case kSameHeading:
      return tight_node(terrain_->known_slot(cell) - 1, heading_of(node));
    case kTurnFromBelow:
      return tight_node((node - cells_) / kHeadings, heading_of(node) - 1);
    default:
      return tight_node((node - cells_) / kHeadings, heading_of(node) + 1);
  }
}

std::optional<std::uint64_t> Graph::cost_between_roomy(Node from, int step) {
  const std::uint16_t here = terrain_->field(from);
  const std::uint16_t there = terrain_->field(neighbour(from, step));
  const auto is_roomy = [](std::uint16_t field) { return Terrain::class_of(field) == Terrain::Class::roomy; };
  if (!is_roomy(here) || !is_roomy(there)) return std::nullopt;
  if (corners_block_ && (step & 1) != 0 &&
      !(is_roomy(terrain_->field(neighbour(from, (step + 1) & 7))) &&
        is_roomy(terrain_->field(neighbour(from, (step - 1) & 7))))) {
    return std::nullopt;
  }
  return move_cost(step, here, there);
}

std::optional<std::uint64_t> Graph::cost_above(Node child, Link link) {
  if (!is_tight(child) && link >> 3 == kRoomyParent) return cost_between_roomy(child, link & 7);
  std::optional<std::uint64_t> result;
  const Node wanted = parent(child, link);
  edges_above(child, [&](Node node, std::uint64_t cost, Link) {
    if (node == wanted) result = cost;
  });
  return result;
}

}  // namespace scanway::planning
