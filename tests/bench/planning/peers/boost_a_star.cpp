#include "tests/bench/planning/peers/boost_a_star.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <boost/graph/astar_search.hpp>
#include <boost/graph/compressed_sparse_row_graph.hpp>

namespace scanway::bench {
namespace {

struct Weight {
  float weight = 0.0f;
};
using Edges = boost::compressed_sparse_row_graph<boost::directedS, boost::no_property, Weight, boost::no_property,
                                                 std::uint32_t, std::uint32_t>;
using Vertex = std::uint32_t;

class Octile : public boost::astar_heuristic<Edges, double> {
 public:
  explicit Octile(std::int32_t side) : side_(static_cast<Vertex>(side)) {}
  double operator()(Vertex vertex) const {
    const double x = side_ - 1 - vertex % side_, y = side_ - 1 - vertex / side_;
    return std::max(x, y) + (std::sqrt(2.0) - 1.0) * std::min(x, y);
  }

 private:
  Vertex side_;
};

struct Arrived {};

class Visitor : public boost::default_astar_visitor {
 public:
  Visitor(Vertex goal, std::uint64_t& expansions) : goal_(goal), expansions_(&expansions) {}
  void examine_vertex(Vertex vertex, const Edges&) const {
    if (vertex == goal_) throw Arrived();
    ++*expansions_;
  }

 private:
  Vertex goal_;
  std::uint64_t* expansions_;
};

/// The same neighbours and prices as textbook_a_star().
template <class Visit>
void for_edges(const PlainMap& map, std::int32_t x, std::int32_t y, Visit&& visit) {
  const std::int32_t n = map.side;
  const auto price = [&](std::int32_t i, std::int32_t j) {
    return i >= 0 && j >= 0 && i < n && j < n ? map.price[static_cast<std::size_t>(j * n + i)] : 0.0f;
  };
  if (price(x, y) == 0.0f) return;
  for (std::int32_t dy = -1; dy <= 1; ++dy) {
    for (std::int32_t dx = -1; dx <= 1; ++dx) {
      const bool diagonal = dx != 0 && dy != 0;
      if ((dx == 0 && dy == 0) || price(x + dx, y + dy) == 0.0f) continue;
      if (diagonal && (price(x + dx, y) == 0.0f || price(x, y + dy) == 0.0f)) continue;
      const double length = diagonal ? std::sqrt(2.0) : 1.0;
      visit((y + dy) * n + x + dx, static_cast<float>(length * 0.5 * (price(x, y) + price(x + dx, y + dy))));
    }
  }
}

}  // namespace

struct BoostAStar::Graph {
  std::int32_t side;
  Edges edges;
};

BoostAStar::BoostAStar(const PlainMap& map) {
  std::vector<std::pair<Vertex, Vertex>> pairs;
  std::vector<Weight> weights;
  for (std::int32_t y = 0; y < map.side; ++y) {
    for (std::int32_t x = 0; x < map.side; ++x) {
      for_edges(map, x, y, [&](std::int32_t to, float weight) {
        pairs.emplace_back(static_cast<Vertex>(y * map.side + x), static_cast<Vertex>(to));
        weights.push_back({weight});
      });
    }
  }
  graph_ = std::make_unique<Graph>(
      Graph{map.side, Edges(boost::edges_are_sorted, pairs.begin(), pairs.end(), weights.begin(),
                            static_cast<Vertex>(map.side) * static_cast<Vertex>(map.side))});
}

BoostAStar::~BoostAStar() = default;

PlainAnswer BoostAStar::search() const {
  const Edges& edges = graph_->edges;
  const Vertex goal = boost::num_vertices(edges) - 1;
  std::vector<double> distance(boost::num_vertices(edges));
  PlainAnswer answer{std::numeric_limits<double>::infinity(), 0};
  const auto index = boost::get(boost::vertex_index, edges);
  try {
    boost::astar_search(edges, Vertex{0}, Octile(graph_->side),
                        boost::weight_map(boost::get(&Weight::weight, edges))
                            .distance_map(boost::make_iterator_property_map(distance.begin(), index))
                            .visitor(Visitor(goal, answer.expansions)));
  } catch (const Arrived&) {
    answer.cost = distance[goal];
  }
  return answer;
}

}  // namespace scanway::bench
