#include "modules/planner/core/search/graph.h"

#include <stdexcept>

namespace scanway::planning {

Graph::Graph(Terrain& terrain, Root root, const Units& units)
    : terrain_(&terrain),
      root_(root),
      cells_(static_cast<Node>(terrain.frame().cells())),
      corners_block_(terrain.options().mode != BodyMode::footprint),
      units_({units.straight, units.diagonal}),
      row_reciprocal_(~std::uint64_t{0} / static_cast<std::uint64_t>(terrain.frame().width) + 1),
      least_straight_(straight()),
      least_diagonal_rise_(2 * (units.diagonal - units.straight) * terrain.weight_one()) {
  for (int step = 0; step < kSteps; ++step) {
    const auto at = static_cast<std::size_t>(step);
    offset_[at] = kStepY[at] * terrain.frame().width + kStepX[at];
  }
}

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

std::optional<std::uint64_t> Graph::cost_above(Node child, Link link) {
  std::optional<std::uint64_t> result;
  const Node wanted = parent(child, link);
  edges_above(child, [&](Node node, std::uint64_t cost, Link) {
    if (node == wanted) result = cost;
  });
  return result;
}

}  // namespace scanway::planning
