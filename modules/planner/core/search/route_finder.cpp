#include "modules/planner/core/search/route_finder.h"

#include <algorithm>

#include "modules/planner/core/search/graph_edges.h"

namespace scanway::planning {

void RouteFinder::change(const std::vector<std::uint32_t>& cells) {
  if (tree_ && !tree_->is_new && !cells.empty()) tree_->search.change(cells);
}

Root RouteFinder::choose_root(Cell start, Cell goal) const {
  if (!tree_) return Root::goal;
  if (tree_->graph.root() == Root::goal) return goal != goal_ && start == start_ ? Root::start : Root::goal;
  return start == start_ ? Root::start : Root::goal;
}

std::optional<Route> RouteFinder::find(Cell start, Cell goal) {
  const Root root = choose_root(start, goal);
  std::optional<Route> route;
  try {
    route = find_with_tree(start, goal, root);
  } catch (const CostOverflow&) {
    units_ = Graph::kCoarse;
    tree_.reset();
    route = find_with_tree(start, goal, root);
  }
  start_ = start;
  goal_ = goal;
  return route;
}

std::optional<Route> RouteFinder::find_with_tree(Cell start, Cell goal, Root root) {
  if (!tree_ || tree_->graph.root() != root) tree_ = std::make_unique<Tree>(*terrain_, root, units_);
  const Cell from = root == Root::goal ? goal : start;
  const Cell target = root == Root::goal ? start : goal;
  DStarLite& search = tree_->search;
  const std::vector<Node> roots = nodes_at(from);
  const std::vector<Node> targets = nodes_at(target);
  if (tree_->is_new || roots != search.roots() || !search.move_target(target)) search.start(roots, target);
  tree_->is_new = false;
  if (!search.search(targets)) {
    search.start(roots, target);
    search.search(targets);
  }
  const std::optional<Node> reached = search.reached(targets);
  if (!reached) return std::nullopt;
  return route_from(*reached);
}

std::vector<Node> RouteFinder::nodes_at(Cell cell) {
  std::vector<Node> nodes;
  tree_->graph.nodes_of(terrain_->frame().index(cell), [&](Node node) { nodes.push_back(node); });
  return nodes;
}

Route RouteFinder::route_from(Node target) {
  Route route;
  route.cost_cells = static_cast<double>(tree_->search.cost(target)) / static_cast<double>(tree_->graph.straight());
  for (const Node node : tree_->search.way_up(target)) {
    Place place{terrain_->frame().cell(tree_->graph.index_of(node)), std::nullopt};
    if (tree_->graph.is_tight(node)) place.heading = tree_->graph.heading_of(node);
    route.places.push_back(place);
  }
  if (tree_->graph.root() == Root::start) std::reverse(route.places.begin(), route.places.end());
  return route;
}

Effort RouteFinder::take_effort() { return tree_ ? tree_->search.take_effort() : Effort{}; }

}  // namespace scanway::planning
