#pragma once

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "modules/planner/core/search/bucket_queue.h"
#include "modules/planner/core/search/graph.h"

namespace scanway::planning {

/// What a search did.
struct Effort {
  std::uint64_t expansions = 0;  ///< Nodes whose neighbours were looked at.
  std::uint64_t dropped = 0;     ///< Nodes that lost their value because what they hung on was gone or dearer.
  bool anew = false;             ///< It started over.
};

/// Thrown when costs outgrow their 40 bits.
struct CostOverflow : std::overflow_error {
  CostOverflow() : std::overflow_error("a way costs more than 40 bits hold") {}
};

/// D* Lite (Koenig and Likhachev, AAAI 2002; the optimised version with k_m and one tie-break): the least cost from the
/// tree's root to the target, kept up while the target moves and the map changes.
///
/// A node's value is D* Lite's rhs, and `open` says that its g is another: the node is in the queue. A node whose
/// parent is gone or dearer waits in a queue of its own, at the key of its old value. When its turn comes, it moves
/// over to another parent of the same cost, and all below it stays as it is; or it loses its value, is offered the best
/// that is around, and its children wait in turn. What lies behind the robot has keys that never come up. So g needs no
/// memory of its own, and the costs found are the same.
class DStarLite {
 public:
  explicit DStarLite(Graph& graph);

  /// Forgets everything; the tree grows from `roots`.
  void start(std::vector<Node> roots, Cell target);
  /// The search aims at another cell from now on. Returns false, and needs start(), after a very long way.
  bool move_target(Cell target);
  /// Takes over a change of the terrain at these cells (by index, in order).
  void change(const std::vector<std::uint32_t>& cells);
  /// Finds the least cost of any of `targets`, all in the target cell. Returns false, and needs start(), when changes
  /// undo so much that a new search costs less.
  bool search(const std::vector<Node>& targets);
  /// The cheapest of `targets` after a search; nothing when none is reached.
  std::optional<Node> reached(const std::vector<Node>& targets);

  std::uint64_t cost(Node node) { return value(node); }
  /// From the node up to the root.
  std::vector<Node> way_up(Node node);
  const std::vector<Node>& roots() const { return roots_; }
  Effort take_effort() { return std::exchange(effort_, {}); }

 private:
  static constexpr std::uint64_t kInfinite = CellWord::kInfinite;
  static constexpr std::uint8_t kOpen = 0x40;
  static constexpr std::uint8_t kRoot = 0x80;

  CellWord& word(Node node) { return node < cells_ ? graph_->terrain().word(node) : tight(node); }
  CellWord& tight(Node node);
  static void close(CellWord& word) { word.set_tag(word.tag() & static_cast<std::uint8_t>(~kOpen)); }
  std::uint64_t value(Node node) { return word(node).value(); }
  std::uint8_t tag(Node node) { return word(node).tag(); }
  std::uint64_t ahead(std::int32_t x, std::int32_t y) const { return graph_->least_cost(x - target_.x, y - target_.y); }
  std::uint64_t key(Node node, std::uint64_t value) const;
  void lower(Node node, std::uint64_t value, Link link);
  void expand_all(std::uint64_t bucket, const std::vector<Node>& targets, std::vector<Node>& beyond);
  void look_at(Node node, std::uint64_t bucket, std::uint64_t goal, std::vector<Node>& beyond);
  void expand(Node node, Cell cell);
  bool expand_roomy(Node node, Cell cell);
  struct Offer {
    std::uint64_t value = kInfinite;
    Link link = 0;
  };
  Offer best_offer(Node node, std::uint8_t leave_out);
  bool is_supported(Node node);
  void wait_to_rise(Node node);
  bool rise_before(const std::vector<Node>& targets);
  bool rise_all(std::uint64_t bucket);
  void rise_if_due(Node node, std::uint64_t bucket);
  void rise(Node node);
  void find_again(Node node);
  std::uint64_t least(const std::vector<Node>& targets);
  std::uint64_t next_bucket(const std::vector<Node>& targets);
  std::vector<std::uint32_t> with_neighbours(const std::vector<std::uint32_t>& cells) const;

  Graph* graph_;
  Node cells_;
  std::vector<CellWord> tight_;
  BucketQueue queue_;
  BucketQueue rising_;
  std::vector<Node> roots_;
  Cell target_;
  std::uint64_t k_m_ = 0;
  std::vector<Node> dropped_;           ///< Have lost their value and not been asked for another.
  std::uint64_t may_drop_ = 0;          ///< In this search, before a new one costs less.
  std::uint64_t first_expansions_ = 0;  ///< What the last search from nothing took.
  Effort effort_;
};

}  // namespace scanway::planning
