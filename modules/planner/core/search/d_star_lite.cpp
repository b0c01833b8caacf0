#include "modules/planner/core/search/d_star_lite.h"

#include <algorithm>
#include <bit>

#include "modules/planner/core/search/graph_edges.h"

namespace scanway::planning {
namespace {

/// Changes that undo more than this share of the last full search are not worth repairing: what is dropped has to be
/// found again, and what lies beyond it too. Until the planner notices, all that was done is wasted.
constexpr std::uint64_t kWorthRepairing = 10;
constexpr std::uint64_t kAlwaysRepaired = 64;
/// The queue's buckets begin at 0, so k_m costs memory as it grows.
constexpr std::uint64_t kLongestWay = 1u << 20;

}  // namespace

DStarLite::DStarLite(Graph& graph)
    : graph_(&graph),
      cells_(static_cast<Node>(graph.terrain().frame().cells())),
      queue_(std::bit_width(graph.straight()) - 1),
      rising_(std::bit_width(graph.straight()) - 1) {}

CellWord& DStarLite::tight(Node node) {
  const std::size_t at = node - cells_;
  if (at >= tight_.size()) tight_.resize(graph_->terrain().slots() * kHeadings);
  return tight_[at];
}

std::uint64_t DStarLite::key(Node node, std::uint64_t value) const {
  const Cell cell = graph_->cell_of(node);
  return value + ahead(cell.x, cell.y) + k_m_;
}

void DStarLite::lower(Node node, std::uint64_t value, Link link) {
  if (value >= kInfinite) throw CostOverflow();
  CellWord& known = word(node);
  known.set_value(value);
  known.set_tag(static_cast<std::uint8_t>((known.tag() & kRoot) | kOpen | link));
  queue_.push(key(node, value), node);
}

void DStarLite::start(std::vector<Node> roots, Cell target) {
  graph_->terrain().forget_search();
  tight_.clear();
  queue_.clear();
  rising_.clear();
  roots_ = std::move(roots);
  target_ = target;
  k_m_ = 0;
  first_expansions_ = 0;
  for (const Node root : roots_) {
    word(root).set_tag(kRoot);
    lower(root, 0, 0);
  }
  effort_.anew = true;
}

bool DStarLite::move_target(Cell target) {
  k_m_ += graph_->least_cost(target.x - target_.x, target.y - target_.y);
  target_ = target;
  return k_m_ / graph_->straight() < kLongestWay;
}

/// What most nodes are: a cell inside its block, it and its neighbours all roomy or blocked. Returns false, and has
/// done nothing, for any other node.
bool DStarLite::expand_roomy(Node node, Cell cell) {
  auto steps = graph_->gaining_steps(node);
  if (!steps) return false;
  CellWord* const words = &graph_->terrain().word(node);
  const std::uint64_t here = words->value();
  if (here >= kInfinite - graph_->dearest_step()) throw CostOverflow();
  close(*words);
  for (; *steps != 0; *steps &= *steps - 1) {
    const int step = __builtin_ctz(*steps);
    const auto at = static_cast<std::size_t>(step);
    const std::uint64_t value = here + graph_->cost_of_step(words, step);
    CellWord& next = words[kInnerStep[at]];
    const auto tag = static_cast<std::uint8_t>((next.tag() & kRoot) | kOpen | Graph::link_to_roomy_parent(step));
    next = {CellWord::with_value(value).bits | std::uint64_t{next.field()} << CellWord::kFieldShift | tag};
    queue_.push(value + k_m_ + ahead(cell.x + kStepX[at], cell.y + kStepY[at]),
                node + static_cast<std::uint32_t>(kInnerStep[at]));
  }
  return true;
}

void DStarLite::expand(Node node, Cell cell) {
  ++effort_.expansions;
  if (expand_roomy(node, cell)) return;
  close(word(node));
  const std::uint64_t here = value(node);
  graph_->edges_below(node, [&](Node next, std::uint64_t cost, Link link) {
    if (here + cost < value(next)) lower(next, here + cost, link);
  });
}

std::uint64_t DStarLite::least(const std::vector<Node>& targets) {
  std::uint64_t least = kInfinite;
  for (const Node target : targets) least = std::min(least, value(target));
  return least;
}

bool DStarLite::search(const std::vector<Node>& targets) {
  const std::uint64_t before = effort_.expansions;
  may_drop_ = effort_.dropped + std::max(kAlwaysRepaired, first_expansions_ / kWorthRepairing);
  std::vector<Node> beyond;
  while (true) {
    if (!rise_before(targets)) return false;
    const std::uint64_t goal = least(targets);
    const std::uint64_t bucket = queue_.lowest();
    if (bucket == BucketQueue::kNone || (goal != kInfinite && queue_.lowest_key_of(bucket) >= goal + k_m_)) break;
    expand_all(bucket, targets, beyond);
  }
  for (const Node node : beyond) queue_.push(key(node, value(node)), node);
  first_expansions_ = std::max(first_expansions_, effort_.expansions - before);
  return true;
}

/// Expands what is in a bucket; compiled in one piece, as all the time goes by here.
[[gnu::flatten, gnu::target_clones("default", "avx2")]] void DStarLite::expand_all(std::uint64_t bucket,
                                                                                   const std::vector<Node>& targets,
                                                                                   std::vector<Node>& beyond) {
  queue_.empty(
      bucket, [this](Node node) { graph_->prefetch(node); },
      [&](Node node) { look_at(node, bucket, least(targets), beyond); });
}

void DStarLite::look_at(Node node, std::uint64_t bucket, std::uint64_t goal, std::vector<Node>& beyond) {
  const CellWord known = word(node);
  if ((known.tag() & kOpen) == 0) return;
  const Cell cell = graph_->cell_of(node);
  const std::uint64_t now = known.value() + ahead(cell.x, cell.y) + k_m_;
  if (queue_.bucket_of(now) > bucket) {
    queue_.push(now, node);
  } else if (goal != kInfinite && now >= goal + k_m_) {
    beyond.push_back(node);
  } else {
    expand(node, cell);
  }
}

std::optional<Node> DStarLite::reached(const std::vector<Node>& targets) {
  const std::uint64_t goal = least(targets);
  if (goal == kInfinite) return std::nullopt;
  return *std::find_if(targets.begin(), targets.end(), [&](Node target) { return value(target) == goal; });
}

bool DStarLite::is_supported(Node node) {
  const Link link = tag(node) & kLinkMask;
  const std::uint64_t parent = value(graph_->parent(node, link));
  if (parent == kInfinite) return false;
  const auto cost = graph_->cost_above(node, link);
  return cost && value(node) >= parent + *cost;
}

[[gnu::target_clones("default", "avx2")]] DStarLite::Offer DStarLite::best_offer(Node node) {
  Offer best;
  const auto consider = [&](std::uint64_t there, std::uint64_t cost, Link link) {
    if (there != kInfinite && there + cost < best.value) best = {there + cost, link};
  };
  if (auto steps = graph_->open_steps(node)) {
    const CellWord* const words = &graph_->terrain().word(node);
    for (; *steps != 0; *steps &= *steps - 1) {
      const int step = __builtin_ctz(*steps);
      const std::uint64_t there = words[kInnerStep[static_cast<std::size_t>(step)]].value();
      consider(there, graph_->cost_of_step(words, step), link_of(step, kRoomyParent));
    }
    return best;
  }
  graph_->edges_above(node, [&](Node above, std::uint64_t cost, Link link) { consider(value(above), cost, link); });
  return best;
}

void DStarLite::wait_to_rise(Node node) { rising_.push(key(node, value(node)), node); }

/// The bucket of the next node to expand, or of the targets when they come before it.
std::uint64_t DStarLite::next_bucket(const std::vector<Node>& targets) {
  const std::uint64_t goal = least(targets);
  return goal == kInfinite ? queue_.lowest() : std::min(queue_.lowest(), queue_.bucket_of(goal + k_m_));
}

/// Takes all that waits up to and with the next bucket: so what is expanded, and the way found, rests on nothing that
/// is gone. Returns false when that is more than it is worth.
bool DStarLite::rise_before(const std::vector<Node>& targets) {
  for (std::uint64_t bucket = rising_.lowest(); bucket != BucketQueue::kNone; bucket = rising_.lowest()) {
    if (bucket > next_bucket(targets)) return true;
    rising_.empty(
        bucket, [this](Node node) { graph_->prefetch(node); },
        [&](Node node) {
          if (effort_.dropped <= may_drop_) rise_if_due(node, bucket);
        });
    if (effort_.dropped > may_drop_) return false;
  }
  return true;
}

void DStarLite::rise_if_due(Node node, std::uint64_t bucket) {
  if (value(node) == kInfinite || (tag(node) & kRoot) != 0 || is_supported(node)) return;
  const std::uint64_t now = key(node, value(node));
  if (rising_.bucket_of(now) > bucket) {
    rising_.push(now, node);
  } else {
    rise(node);
  }
}

/// Another parent at no higher cost will do, even one that has to rise later, as this node then does too. It is none
/// of those that hang on the node: they are dearer, or wait.
void DStarLite::rise(Node node) {
  const Offer best = best_offer(node);
  if (best.value == value(node)) {
    word(node).set_tag(static_cast<std::uint8_t>((tag(node) & kOpen) | best.link));
    return;
  }
  if (best.value > value(node)) {
    ++effort_.dropped;
    word(node).set_value(kInfinite);
    word(node).set_tag(0);
    graph_->possible_children(node, [&](Node child, Link link) {
      if (value(child) != kInfinite && (tag(child) & (kLinkMask | kRoot)) == link) wait_to_rise(child);
    });
  }
  if (best.value != kInfinite) lower(node, best.value, best.link);
}

std::vector<std::uint32_t> DStarLite::with_neighbours(const std::vector<std::uint32_t>& cells) const {
  std::vector<std::uint32_t> all = cells;
  const Frame& frame = graph_->terrain().frame();
  for (const std::uint32_t cell : cells) {
    for (std::size_t step = 0; step < kSteps; ++step) {
      all.push_back(frame.beside(cell, kStepX[step], kStepY[step]));
    }
  }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

void DStarLite::change(const std::vector<std::uint32_t>& cells) {
  const std::vector<std::uint32_t> around = with_neighbours(cells);
  for (const std::uint32_t cell : around) {
    graph_->possible_nodes_of(cell, [&](Node node) {
      if (value(node) != kInfinite && (tag(node) & kRoot) == 0 && !is_supported(node)) wait_to_rise(node);
    });
  }
  for (const std::uint32_t cell : around) {
    graph_->nodes_of(cell, [&](Node node) {
      const Offer best = best_offer(node);
      if (best.value < value(node)) lower(node, best.value, best.link);
    });
  }
}

std::vector<Node> DStarLite::way_up(Node node) {
  std::vector<Node> way = {node};
  while ((tag(way.back()) & kRoot) == 0) way.push_back(graph_->parent(way.back(), tag(way.back()) & kLinkMask));
  return way;
}

}  // namespace scanway::planning
