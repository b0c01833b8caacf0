#include "modules/mapper/core/octomap/tree_update.h"

#include <algorithm>
#include <span>
#include <vector>

#include <tbb/enumerable_thread_specific.h>

#include "common/parallel/blocks.h"

namespace scanway {
namespace {

using Node = octomap::OcTreeNode;
using Words = std::span<const std::uint64_t>;

constexpr std::size_t kBricksInBlock = 16;

bool all(Words words) {
  return std::all_of(words.begin(), words.end(), [](std::uint64_t word) { return word == ~std::uint64_t{0}; });
}

bool none(Words words) {
  std::uint64_t any = 0;
  for (const std::uint64_t word : words) any |= word;
  return any == 0;
}

/// What a sweep says of a cube: its voxels' bits.
struct Cube {
  Words free, occupied;

  bool untouched() const { return none(free) && none(occupied); }
  Cube child(std::size_t i) const {
    const std::size_t words = free.size() / 8;
    return {free.subspan(i * words, words), occupied.subspan(i * words, words)};
  }
};

/// A cube of 64 voxels or fewer, in the lowest bits.
struct SmallCube {
  std::uint64_t free, occupied;
};

class SweepUpdate {
 public:
  explicit SweepUpdate(octomap::OcTree& tree)
      : tree_(tree),
        hit_(tree.getProbHitLog()),
        miss_(tree.getProbMissLog()),
        min_(tree.getClampingThresMinLog()),
        max_(tree.getClampingThresMaxLog()) {}

  void update(Node* node, bool is_new, const Cube& cube) {
    if (cube.free.size() == 1) return update(node, is_new, 2, SmallCube{cube.free[0], cube.occupied[0]});
    const bool leaf = is_new || !tree_.nodeHasChildren(node);
    if (leaf) {
      if (none(cube.occupied) && (all(cube.free) || at_bound(node, is_new, false))) return add(node, miss_);
      if (none(cube.free) && (all(cube.occupied) || at_bound(node, is_new, true))) return add(node, hit_);
      if (!is_new) tree_.expandNode(node);
    }
    for (unsigned i = 0; i < 8; ++i) {
      const Cube part = cube.child(i);
      if (part.untouched()) continue;
      bool child_is_new = false;
      Node* child = child_of(node, i, child_is_new);
      update(child, child_is_new, part);
    }
    finish(node);
  }

  Node* child_of(Node* node, unsigned i, bool& is_new) {
    is_new = !tree_.nodeChildExists(node, i);
    return is_new ? tree_.createNodeChild(node, i) : tree_.getNodeChild(node, i);
  }

  void finish(Node* node) {
    if (!tree_.pruneNode(node)) node->updateOccupancyChildren();
  }

 private:
  void update(Node* node, bool is_new, int level, SmallCube cube) {
    const int voxels = 1 << (3 * level);
    const std::uint64_t full = level == 2 ? ~std::uint64_t{0} : (std::uint64_t{1} << voxels) - 1;
    if (is_new || !tree_.nodeHasChildren(node)) {
      if (cube.occupied == 0 && (cube.free == full || at_bound(node, is_new, false))) return add(node, miss_);
      if (cube.free == 0 && (cube.occupied == full || at_bound(node, is_new, true))) return add(node, hit_);
      if (!is_new) tree_.expandNode(node);
    }
    const std::uint64_t part = full >> (voxels - voxels / 8);
    for (unsigned i = 0; i < 8; ++i) {
      const SmallCube of_child{cube.free >> (i * voxels / 8) & part, cube.occupied >> (i * voxels / 8) & part};
      if ((of_child.free | of_child.occupied) == 0) continue;
      bool child_is_new = false;
      Node* child = child_of(node, i, child_is_new);
      update(child, child_is_new, level - 1, of_child);
    }
    finish(node);
  }

  /// Whether a leaf's value can go no further, so that it does not matter which of its voxels are touched.
  bool at_bound(const Node* node, bool is_new, bool up) const {
    return !is_new && (up ? node->getLogOdds() >= max_ : node->getLogOdds() <= min_);
  }

  void add(Node* node, float log_odds) const {
    node->setLogOdds(std::min(std::max(node->getLogOdds() + log_odds, min_), max_));
  }

  octomap::OcTree& tree_;
  float hit_, miss_, min_, max_;
};

using Numbers = std::span<const VoxelBricks::BrickNumber>;

struct BrickNode {
  Node* node;
  bool is_new;
};

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
void descend(SweepUpdate& update, octomap::OcTree& tree, BrickNode at, int level, Numbers numbers,
             std::vector<BrickNode>& nodes) {
  if (level == kBrickLevel) return nodes.push_back(at);
  if (!at.is_new && !tree.nodeHasChildren(at.node)) tree.expandNode(at.node);
  for_children(numbers, level, [&](unsigned i, Numbers of_child) {
    BrickNode child{};
    child.node = update.child_of(at.node, i, child.is_new);
    descend(update, tree, child, level - 1, of_child, nodes);
  });
}

void ascend(SweepUpdate& update, octomap::OcTree& tree, Node* node, int level, Numbers numbers) {
  if (level == kBrickLevel) return;
  for_children(numbers, level, [&](unsigned i, Numbers of_child) {
    ascend(update, tree, tree.getNodeChild(node, i), level - 1, of_child);
  });
  update.finish(node);
}

void prefer_occupied(VoxelBrick& brick) {
  for (std::size_t w = 0; w < kBrickWords; ++w) brick.free[w] &= ~brick.occupied[w];
}

}  // namespace

void SweptOcTree::update(VoxelBricks& bricks) {
  const std::vector<VoxelBricks::BrickNumber> numbers = bricks.numbers();
  if (numbers.empty()) return;
  const bool root_is_new = root == nullptr;
  if (root_is_new) {
    root = new Node();
    ++tree_size;
  }
  SweepUpdate update(*this);
  std::vector<BrickNode> nodes;
  descend(update, *this, {root, root_is_new}, kTreeLevels, numbers, nodes);
  // Nodes are made and deleted by a tree, which counts them: each thread has one of its own, without a root.
  tbb::enumerable_thread_specific<SweptOcTree> counters([this] { return SweptOcTree(resolution); });
  for_blocks(nodes.size(), kBricksInBlock, [&](std::size_t begin, std::size_t end, std::size_t) {
    SweepUpdate of_thread(counters.local());
    for (std::size_t i = begin; i < end; ++i) {
      VoxelBrick& brick = bricks.at(numbers[i]);
      prefer_occupied(brick);
      of_thread.update(nodes[i].node, nodes[i].is_new, {brick.free, brick.occupied});
    }
  });
  for (const SweptOcTree& counter : counters) tree_size += counter.size();
  ascend(update, *this, root, kTreeLevels, numbers);
  size_changed = true;
}

}  // namespace scanway
