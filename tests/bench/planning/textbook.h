#pragma once

#include <cstdint>
#include <vector>

namespace scanway::bench {

/// A square map of cells: the price of a metre, 0 where an obstacle is.
struct PlainMap {
  std::int32_t side = 0;
  std::vector<float> price;
};

struct PlainAnswer {
  double cost = 0.0;  ///< Infinite when there is no way.
  std::uint64_t expansions = 0;
};

/// A* as textbooks have it: binary heap, octile heuristic, doubles, closed list. From corner to corner.
PlainAnswer textbook_a_star(const PlainMap& map);

}  // namespace scanway::bench
