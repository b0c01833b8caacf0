#include "modules/planner/core/search/d_star_lite.h"

#include <algorithm>
#include <bit>

namespace scanway::planning {
namespace {

/// A change that undoes more than this share of the last full search is not worth repairing: what is dropped has to be
/// found again, and what lies beyond it too.
constexpr std::uint64_t kWorthRepairing = 4;
constexpr std::uint64_t kAlwaysRepaired = 64;
/// The queue's buckets begin at 0, so k_m costs memory as it grows.
constexpr std::uint64_t kLongestWay = 1u << 20;

}  // namespace

template <class Cost>
DStarLite<Cost>::DStarLite(Graph& graph)
    : graph_(&graph),
      cells_(static_cast<Node>(graph.terrain().frame().cells())),
      stored_(cells_),
      tags_(cells_),
      queue_(std::bit_width(graph.straight()) - 1) {}

template <class Cost>
typename DStarLite<Cost>::Tight& DStarLite<Cost>::tight(Node node) {
  const std::size_t at = node - cells_;
  if (at >= tight_.size()) tight_.resize(graph_->terrain().slots() * kHeadings);
  return tight_[at];
}

template <class Cost>
std::uint64_t DStarLite<Cost>::key(Node node, std::uint64_t value) const {
  const Cell cell = graph_->terrain().frame().cell(graph_->index_of(node));
  return value + graph_->least_cost(cell.x - target_.x, cell.y - target_.y) + k_m_;
}

template <class Cost>
void DStarLite<Cost>::lower(Node node, std::uint64_t value, Link link) {
  if (value >= kInfinite) throw CostOverflow();
  set_value(node, value);
  std::uint8_t& flags = tag(node);
  flags = static_cast<std::uint8_t>((flags & kRoot) | kOpen | link);
  queue_.push(key(node, value), node);
}

template <class Cost>
void DStarLite<Cost>::start(std::vector<Node> roots, Cell target) {
  if (!is_first_) {
    stored_.clear();
    tags_.clear();
    tight_.clear();
    queue_.clear();
  }
  is_first_ = false;
  roots_ = std::move(roots);
  target_ = target;
  k_m_ = 0;
  first_expansions_ = 0;
  for (const Node root : roots_) {
    tag(root) = kRoot;
    lower(root, 0, 0);
  }
  effort_.anew = true;
}

template <class Cost>
bool DStarLite<Cost>::move_target(Cell target) {
  k_m_ += graph_->least_cost(target.x - target_.x, target.y - target_.y);
  target_ = target;
  return k_m_ / graph_->straight() < kLongestWay;
}

template <class Cost>
void DStarLite<Cost>::expand(Node node) {
  ++effort_.expansions;
  tag(node) &= static_cast<std::uint8_t>(~kOpen);
  const std::uint64_t here = value(node);
  graph_->edges_below(node, [&](Node next, std::uint64_t cost, Link link) {
    if (here + cost < value(next)) lower(next, here + cost, link);
  });
}

template <class Cost>
std::optional<Node> DStarLite<Cost>::search(const std::vector<Node>& targets) {
  const std::uint64_t before = effort_.expansions;
  const auto best = [&] {
    std::uint64_t least = kInfinite;
    for (const Node target : targets) least = std::min(least, value(target));
    return least;
  };
  std::vector<Node> kept;
  std::uint64_t goal = best();
  for (std::uint64_t bucket = queue_.lowest(); bucket != BucketQueue::kNone; bucket = queue_.lowest()) {
    if (goal != kInfinite && queue_.lowest_key_of(bucket) >= goal + k_m_) break;
    const Node node = queue_.pop(bucket);
    if ((tag(node) & kOpen) == 0) continue;
    const std::uint64_t now = key(node, value(node));
    if (queue_.bucket_of(now) > bucket) {
      queue_.push(now, node);
    } else if (goal != kInfinite && now >= goal + k_m_) {
      kept.push_back(node);
    } else {
      expand(node);
      goal = best();
    }
  }
  for (const Node node : kept) queue_.push(key(node, value(node)), node);
  first_expansions_ = std::max(first_expansions_, effort_.expansions - before);
  if (goal == kInfinite) return std::nullopt;
  return *std::find_if(targets.begin(), targets.end(), [&](Node target) { return value(target) == goal; });
}

template <class Cost>
bool DStarLite<Cost>::is_supported(Node node) {
  const Link link = tag(node) & kLinkMask;
  const std::uint64_t parent = value(graph_->parent(node, link));
  if (parent == kInfinite) return false;
  const auto cost = graph_->cost_above(node, link);
  return cost && value(node) >= parent + *cost;
}

template <class Cost>
bool DStarLite<Cost>::drop_below(Node node) {
  const std::uint64_t bound = std::max(kAlwaysRepaired, first_expansions_ / kWorthRepairing);
  std::size_t next = dropped_.size();
  const auto drop = [this](Node lost) {
    set_value(lost, kInfinite);
    tag(lost) = 0;
    dropped_.push_back(lost);
  };
  drop(node);
  for (; next < dropped_.size(); ++next) {
    if (dropped_.size() > bound) return false;
    graph_->possible_children(dropped_[next], [&](Node child, Link link) {
      if (value(child) != kInfinite && (tag(child) & (kLinkMask | kRoot)) == link) drop(child);
    });
  }
  return true;
}

template <class Cost>
void DStarLite<Cost>::offer(Node node) {
  std::uint64_t least = value(node);
  std::optional<Link> best;
  graph_->edges_above(node, [&](Node above, std::uint64_t cost, Link link) {
    const std::uint64_t there = value(above);
    if (there == kInfinite || there + cost >= least) return;
    least = there + cost;
    best = link;
  });
  if (best) lower(node, least, *best);
}

template <class Cost>
std::vector<std::uint32_t> DStarLite<Cost>::with_neighbours(const std::vector<std::uint32_t>& cells) const {
  std::vector<std::uint32_t> all = cells;
  const std::int32_t width = graph_->terrain().frame().width;
  for (const std::uint32_t cell : cells) {
    for (std::size_t step = 0; step < kSteps; ++step) {
      all.push_back(cell + static_cast<std::uint32_t>(kStepY[step] * width + kStepX[step]));
    }
  }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

template <class Cost>
bool DStarLite<Cost>::change(const std::vector<std::uint32_t>& cells) {
  const std::vector<std::uint32_t> around = with_neighbours(cells);
  dropped_.clear();
  bool worth = true;
  for (const std::uint32_t cell : around) {
    graph_->possible_nodes_of(cell, [&](Node node) {
      if (!worth || value(node) == kInfinite || (tag(node) & kRoot) != 0 || is_supported(node)) return;
      worth = drop_below(node);
    });
  }
  effort_.dropped += dropped_.size();
  if (!worth) return false;
  for (const std::uint32_t cell : around) graph_->nodes_of(cell, [&](Node node) { offer(node); });
  for (const Node node : dropped_) offer(node);
  return true;
}

template <class Cost>
std::vector<Node> DStarLite<Cost>::way_up(Node node) {
  std::vector<Node> way = {node};
  while ((tag(way.back()) & kRoot) == 0) way.push_back(graph_->parent(way.back(), tag(way.back()) & kLinkMask));
  return way;
}

template class DStarLite<std::uint32_t>;
template class DStarLite<std::uint64_t>;

}  // namespace scanway::planning
