#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "modules/planner/core/body/terrain.h"
#include "modules/planner/core/search/d_star_lite.h"
#include "modules/planner/core/search/graph.h"

namespace scanway::planning {

/// One place on a route: a cell, and the heading there in a tight one.
struct Place {
  Cell cell;
  std::optional<int> heading;
};

struct Route {
  std::vector<Place> places;  ///< From start to goal.
  double cost_cells = 0.0;    ///< In straight steps between cells of weight one.
};

/// The cheapest route between two cells of a terrain, again and again while they move and the terrain changes. What
/// the last search found is kept wherever it can be: the tree's root is at the end that stays.
class RouteFinder {
 public:
  explicit RouteFinder(Terrain& terrain) : terrain_(&terrain) {}

  /// The terrain has changed at these cells.
  void change(const std::vector<std::uint32_t>& cells);
  std::optional<Route> find(Cell start, Cell goal);
  Effort take_effort();

 private:
  /// A search tree with fine costs, or with coarse ones once these have overflowed.
  struct Tree {
    Tree(Terrain& terrain, Root root, const Graph::Units& units) : graph(terrain, root, units), search(graph) {}
    Graph graph;
    DStarLite search;
    bool is_new = true;
  };

  Root choose_root(Cell start, Cell goal) const;
  std::optional<Route> find_with_tree(Cell start, Cell goal, Root root);
  Route route_from(Node target);
  std::vector<Node> nodes_at(Cell cell);

  Terrain* terrain_;
  std::unique_ptr<Tree> tree_;
  Cell start_;
  Cell goal_;
  Graph::Units units_ = Graph::kFine;
};

}  // namespace scanway::planning
