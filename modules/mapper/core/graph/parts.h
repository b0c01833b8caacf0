#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace scanway {

/// Which nodes of a graph hang together (union-find, each part named by its lowest node).
class Parts {
 public:
  explicit Parts(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), std::size_t{0}); }
  std::size_t of(std::size_t node) const {
    while (parent_[node] != node) node = parent_[node];
    return node;
  }
  /// Whether they did not hang together before.
  bool join(std::size_t a, std::size_t b) {
    a = of(a), b = of(b);
    parent_[std::max(a, b)] = std::min(a, b);
    return a != b;
  }

 private:
  std::vector<std::size_t> parent_;
};

}  // namespace scanway
