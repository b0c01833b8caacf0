#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "modules/planner/core/body/lazy_array.h"
#include "modules/planner/core/search/bucket_queue.h"
#include "modules/planner/core/search/graph.h"

namespace scanway::planning {

/// What a search did.
struct Effort {
  std::uint64_t expansions = 0;  ///< Nodes whose neighbours were looked at.
  std::uint64_t dropped = 0;     ///< Nodes that lost their value because what they hung on was gone.
  bool anew = false;             ///< It started over.
};

/// Thrown when costs outgrow their 32 bits.
struct CostOverflow {};

/// D* Lite (Koenig and Likhachev, AAAI 2002; the optimised version with k_m and one tie-break): the least cost from the
/// tree's root to the target, kept up while the target moves and the map changes.
///
/// A node's value is D* Lite's rhs, and `open` says that its g is another: the node is in the queue. Instead of raising
/// a node's g to infinity when it comes up in the queue, and then those of the nodes that rest on it one by one, all
/// that hang on an edge that is gone or dearer lose their value at once, by the parent links, and are offered what
/// is left around them. So no node is ever below its true value, g needs no memory of its own, and the size of a
/// change is known before the search begins. The costs found are the same.
template <class Cost>
class DStarLite {
 public:
  explicit DStarLite(Graph& graph);

  /// Forgets everything; the tree grows from `roots`.
  void start(std::vector<Node> roots, Cell target);
  /// The search aims at another cell from now on. Returns false, and needs start(), after a very long way.
  bool move_target(Cell target);
  /// Takes over a change of the terrain at these cells (by index, in order). Returns false, and needs start(), when the
  /// change undoes so much that a new search costs less.
  bool change(const std::vector<std::uint32_t>& cells);
  /// Finds the least cost of any of `targets`, all in the target cell. Returns that node; nothing when none is reached.
  std::optional<Node> search(const std::vector<Node>& targets);

  std::uint64_t cost(Node node) { return value(node); }
  /// From the node up to the root.
  std::vector<Node> way_up(Node node);
  const std::vector<Node>& roots() const { return roots_; }
  Effort take_effort() { return std::exchange(effort_, {}); }

 private:
  static constexpr std::uint64_t kInfinite = static_cast<Cost>(~Cost{0});
  static constexpr std::uint8_t kOpen = 0x40;
  static constexpr std::uint8_t kRoot = 0x80;
  /// Values are stored as their complement, so that memory that was never touched holds infinity.
  struct Tight {
    Cost stored = 0;
    std::uint8_t tag = 0;
  };

  Cost& stored(Node node) { return node < cells_ ? stored_[node] : tight(node).stored; }
  std::uint8_t& tag(Node node) { return node < cells_ ? tags_[node] : tight(node).tag; }
  Tight& tight(Node node);
  std::uint64_t value(Node node) { return static_cast<Cost>(~stored(node)); }
  void set_value(Node node, std::uint64_t value) { stored(node) = static_cast<Cost>(~static_cast<Cost>(value)); }
  std::uint64_t key(Node node, std::uint64_t value) const;
  void lower(Node node, std::uint64_t value, Link link);
  void expand(Node node);
  bool is_supported(Node node);
  bool drop_below(Node node);
  void offer(Node node);
  std::vector<std::uint32_t> with_neighbours(const std::vector<std::uint32_t>& cells) const;

  Graph* graph_;
  Node cells_;
  LazyArray<Cost> stored_;
  LazyArray<std::uint8_t> tags_;
  std::vector<Tight> tight_;
  BucketQueue queue_;
  std::vector<Node> roots_;
  Cell target_;
  std::uint64_t k_m_ = 0;
  std::vector<Node> dropped_;
  std::uint64_t first_expansions_ = 0;  ///< What the last search from nothing took.
  bool is_first_ = true;
  Effort effort_;
};

extern template class DStarLite<std::uint32_t>;
extern template class DStarLite<std::uint64_t>;

}  // namespace scanway::planning
