#include "modules/mapper/core/octomap/log_odds_tree.h"

#include <span>

#include <tbb/enumerable_thread_specific.h>

#include "common/parallel/blocks.h"
#include "modules/mapper/core/octomap/node_update.h"

namespace scanway {
namespace {

constexpr std::size_t kBricksInBlock = 16;

using Numbers = std::span<const VoxelBricks::BrickNumber>;

/// Calls visit(i, numbers of child i) for each of the eight children that holds bricks.
template <class Visit>
void for_children(Numbers numbers, int level, const Visit& visit) {
  const int shift = 3 * (level - 1 - kBrickLevel);
  while (!numbers.empty()) {
    const auto child = static_cast<unsigned>(numbers.front() >> shift & 7);
    std::size_t count = 1;
    while (count < numbers.size() && numbers[count] >> shift == numbers.front() >> shift) ++count;
    visit(child, numbers.first(count));
    numbers = numbers.subspan(count);
  }
}

/// The nodes of the bricks, made where there are none, in the order of the numbers.
void descend(NodeUpdate& update, const Node& at, int level, Numbers numbers, std::vector<Node>& nodes) {
  if (level == kBrickLevel) return nodes.push_back(at);
  if (at.is_leaf()) update.open(at);
  for_children(numbers, level, [&](unsigned i, Numbers of_child) {
    descend(update, update.child_of(at, i), level - 1, of_child, nodes);
  });
}

void ascend(NodeUpdate& update, const Node& node, int level, Numbers numbers) {
  if (level == kBrickLevel) return;
  for_children(numbers, level,
               [&](unsigned i, Numbers of_child) { ascend(update, update.place_of(node, i), level - 1, of_child); });
  update.finish_or_remove(node);
}

/// The nodes of the bricks as `work` leaves them, and with them all above.
template <class Work>
void on_nodes(TreeBlocks& blocks, NodeBlock& top, const BrickNumbers& numbers, const Work& work) {
  if (numbers.empty()) return;
  const Node root{&top, 0, !top.has(0)};
  if (root.is_new) root.log_odds() = 0.0f;
  NodeUpdate update(blocks);
  std::vector<Node> nodes;
  descend(update, root, kTreeLevels, numbers, nodes);
  work(nodes);
  ascend(update, root, kTreeLevels, numbers);
}

/// Calls work(update, i) for each i below `n`, each time with the update of its thread.
template <class Work>
void side_by_side(TreeBlocks& blocks, std::size_t n, const Work& work) {
  tbb::enumerable_thread_specific<NodeUpdate> of_thread([&blocks] { return NodeUpdate(blocks); });
  for_blocks(n, kBricksInBlock, [&](std::size_t begin, std::size_t end, std::size_t) {
    NodeUpdate& update = of_thread.local();
    for (std::size_t i = begin; i < end; ++i) work(update, i);
  });
}

}  // namespace

LogOddsTree::LogOddsTree() { top_.fill(kNoNode); }

void LogOddsTree::update(VoxelBricks& bricks) {
  const BrickNumbers numbers = bricks.numbers();
  on_nodes(blocks_, top_, numbers, [&](std::vector<Node>& nodes) {
    side_by_side(blocks_, nodes.size(), [&](NodeUpdate& update, std::size_t i) {
      VoxelBrick& brick = bricks.at(numbers[i]);
      brick.prefer_occupied();
      update.update(nodes[i], brick);
    });
  });
}

void LogOddsTree::remake(const BrickNumbers& numbers, const VoxelHistory& history) {
  on_nodes(blocks_, top_, numbers, [&](std::vector<Node>& nodes) {
    side_by_side(blocks_, nodes.size(), [&](NodeUpdate& update, std::size_t i) {
      update.remove(nodes[i], kBrickLevel);
      nodes[i].is_new = true;
    });
    for (const SweepNumber sweep : history.sweeps()) {
      const VoxelHistory::Page page = history.read(sweep, numbers);
      side_by_side(blocks_, page.size(),
                   [&](NodeUpdate& update, std::size_t i) { update.update(nodes[page.place(i)], page.brick(i)); });
    }
  });
}

}  // namespace scanway
