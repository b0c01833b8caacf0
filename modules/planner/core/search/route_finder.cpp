#include "modules/planner/core/search/route_finder.h"

#include <algorithm>

namespace scanway::planning {

RouteFinder::Tree::Tree(Terrain& terrain, Root root, bool wide)
    : graph(terrain, root, wide ? Graph::kWide : Graph::kNarrow) {
  if (wide) {
    search.emplace<DStarLite<std::uint64_t>>(graph);
  } else {
    search.emplace<DStarLite<std::uint32_t>>(graph);
  }
}

void RouteFinder::change(const std::vector<std::uint32_t>& cells) {
  if (!tree_ || tree_->is_new || cells.empty()) return;
  std::visit(
      [&](auto& search) {
        if constexpr (!std::is_same_v<std::decay_t<decltype(search)>, std::monostate>) {
          search.change(cells);
        }
      },
      tree_->search);
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
    wide_ = true;
    tree_.reset();
    route = find_with_tree(start, goal, root);
  }
  start_ = start;
  goal_ = goal;
  return route;
}

std::optional<Route> RouteFinder::find_with_tree(Cell start, Cell goal, Root root) {
  if (!tree_ || tree_->graph.root() != root) tree_ = std::make_unique<Tree>(*terrain_, root, wide_);
  const Cell from = root == Root::goal ? goal : start;
  const Cell target = root == Root::goal ? start : goal;
  return std::visit(
      [&](auto& search) -> std::optional<Route> {
        if constexpr (std::is_same_v<std::decay_t<decltype(search)>, std::monostate>) {
          return std::nullopt;
        } else {
          return run(search, from, target);
        }
      },
      tree_->search);
}

std::vector<Node> RouteFinder::nodes_at(Cell cell) {
  std::vector<Node> nodes;
  tree_->graph.nodes_of(terrain_->frame().index(cell), [&](Node node) { nodes.push_back(node); });
  return nodes;
}

template <class Search>
std::optional<Route> RouteFinder::run(Search& search, Cell from, Cell target) {
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
  Route route;
  route.cost_cells = static_cast<double>(search.cost(*reached)) / static_cast<double>(tree_->graph.straight());
  for (const Node node : search.way_up(*reached)) {
    Place place{terrain_->frame().cell(tree_->graph.index_of(node)), std::nullopt};
    if (tree_->graph.is_tight(node)) place.heading = tree_->graph.heading_of(node);
    route.places.push_back(place);
  }
  if (tree_->graph.root() == Root::start) std::reverse(route.places.begin(), route.places.end());
  return route;
}

Effort RouteFinder::take_effort() {
  Effort effort;
  if (!tree_) return effort;
  std::visit(
      [&](auto& search) {
        if constexpr (!std::is_same_v<std::decay_t<decltype(search)>, std::monostate>) effort = search.take_effort();
      },
      tree_->search);
  return effort;
}

}  // namespace scanway::planning
