#include "modules/planner/core/search/d_star_lite.h"

#include <algorithm>
#include <bit>

#include "modules/planner/core/search/for_each_cpu.h"
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
  dropped_.clear();
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
SCANWAY_IN_ONE_PIECE void DStarLite::expand_all(std::uint64_t bucket, const std::vector<Node>& targets,
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

std::vector<Node> DStarLite::way_up(Node node) {
  std::vector<Node> way = {node};
  while ((tag(way.back()) & kRoot) == 0) way.push_back(graph_->parent(way.back(), tag(way.back()) & kLinkMask));
  return way;
}

}  // namespace scanway::planning
