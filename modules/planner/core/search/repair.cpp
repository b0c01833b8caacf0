// What D* Lite does about changes of the map.

#include <algorithm>

#include "modules/planner/core/search/d_star_lite.h"
#include "modules/planner/core/search/for_each_cpu.h"
#include "modules/planner/core/search/graph_edges.h"

namespace scanway::planning {

bool DStarLite::is_supported(Node node) {
  const Link link = tag(node) & kLinkMask;
  const std::uint64_t parent = value(graph_->parent(node, link));
  if (parent == kInfinite) return false;
  const auto cost = graph_->cost_above(node, link);
  return cost && value(node) >= parent + *cost;
}

SCANWAY_FOR_EACH_CPU DStarLite::Offer DStarLite::best_offer(Node node, std::uint8_t leave_out) {
  Offer best;
  const auto consider = [&](CellWord there, std::uint64_t cost, Link link) {
    if ((there.tag() & leave_out) != 0 || there.value() == kInfinite) return;
    if (there.value() + cost < best.value) best = {there.value() + cost, link};
  };
  if (auto steps = graph_->open_steps(node)) {
    const CellWord* const words = &graph_->terrain().word(node);
    for (; *steps != 0; *steps &= *steps - 1) {
      const int step = __builtin_ctz(*steps);
      consider(words[kInnerStep[static_cast<std::size_t>(step)]], graph_->cost_of_step(words, step),
               link_of(step, kRoomyParent));
    }
    return best;
  }
  graph_->edges_above(node, [&](Node above, std::uint64_t cost, Link link) { consider(word(above), cost, link); });
  return best;
}

void DStarLite::wait_to_rise(Node node) { rising_.push(key(node, value(node)), node); }

/// The bucket of the next node to expand, or of the targets when they come before it.
std::uint64_t DStarLite::next_bucket(const std::vector<Node>& targets) {
  const std::uint64_t goal = least(targets);
  return goal == kInfinite ? queue_.lowest() : std::min(queue_.lowest(), queue_.bucket_of(goal + k_m_));
}

/// Takes what waits up to and with the next bucket: so what is expanded, and the way found, rests on nothing that is
/// gone. Only when all that is gone has lost its value are the others asked for another: what hangs on the gone would
/// offer it back. Returns false when that is more than it is worth.
bool DStarLite::rise_before(const std::vector<Node>& targets) {
  for (std::uint64_t bucket = rising_.lowest(); bucket != BucketQueue::kNone; bucket = rising_.lowest()) {
    const std::uint64_t next = next_bucket(targets);
    if (bucket > next) return true;
    for (; bucket != BucketQueue::kNone && bucket <= next; bucket = rising_.lowest()) {
      if (!rise_all(bucket)) return false;
    }
    for (const Node node : dropped_) find_again(node);
    dropped_.clear();
  }
  return true;
}

bool DStarLite::rise_all(std::uint64_t bucket) {
  rising_.empty(
      bucket, [this](Node node) { graph_->prefetch(node); },
      [&](Node node) {
        if (effort_.dropped <= may_drop_) rise_if_due(node, bucket);
      });
  return effort_.dropped <= may_drop_;
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
  const Offer best = best_offer(node, 0);
  if (best.value == value(node)) {
    word(node).set_tag(static_cast<std::uint8_t>((tag(node) & kOpen) | best.link));
    return;
  }
  if (best.value < value(node)) return lower(node, best.value, best.link);
  ++effort_.dropped;
  word(node).set_value(kInfinite);
  word(node).set_tag(0);
  dropped_.push_back(node);
  graph_->possible_children(node, [&](Node child, Link link) {
    if (value(child) != kInfinite && (tag(child) & (kLinkMask | kRoot)) == link) wait_to_rise(child);
  });
}

/// What those around that are closed have to offer; the others offer it when they are expanded.
void DStarLite::find_again(Node node) {
  const Offer best = best_offer(node, kOpen);
  if (best.value < value(node)) lower(node, best.value, best.link);
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
      const Offer best = best_offer(node, 0);
      if (best.value < value(node)) lower(node, best.value, best.link);
    });
  }
}

}  // namespace scanway::planning
