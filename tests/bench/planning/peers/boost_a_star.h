#pragma once

#include <memory>

#include "tests/bench/planning/textbook.h"

namespace scanway::bench {

/// Boost.Graph's astar_search on a compressed graph of the free cells' edges, octile heuristic, from corner to corner.
class BoostAStar {
 public:
  explicit BoostAStar(const PlainMap& map);  ///< Makes the graph.
  ~BoostAStar();
  PlainAnswer search() const;

 private:
  struct Graph;
  std::unique_ptr<Graph> graph_;
};

}  // namespace scanway::bench
