#include "modules/mapper/core/octomap/log_odds_tree.h"

#include <algorithm>
#include <span>

#include <tbb/enumerable_thread_specific.h>

#include "common/math/repeatable.h"
#include "common/parallel/blocks.h"

namespace scanway {
namespace {

using Words = std::span<const std::uint64_t>;

constexpr std::size_t kBricksInBlock = 16;

/// octomap::OcTree's default sensor model, rounded to float as there.
struct SensorModel {
  static float log_odds(double probability) {
    return static_cast<float>(repeatable::log(probability / (1.0 - probability)));
  }
  float hit = log_odds(0.7), miss = log_odds(0.4), least = log_odds(0.1192), most = log_odds(0.971);

  float after(float before, float change) const { return std::min(std::max(before + change, least), most); }
};

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

/// A node by its place: in the block of its parent's children.
struct Node {
  NodeBlock* block;
  std::size_t child;
  bool is_new;  ///< Not yet of any value.

  float& log_odds() const { return block->log_odds[child]; }
  BlockNumber& children() const { return block->children[child]; }
  bool is_leaf() const { return children() == 0; }
};

/// One thread's part in an update.
class SweepUpdate {
 public:
  explicit SweepUpdate(NodeBlocks& blocks) : blocks_(blocks), supply_(blocks) {}

  void update(const Node& node, const Cube& cube) {
    if (cube.free.size() == 1) return update_word(node, {cube.free[0], cube.occupied[0]});
    if (node.is_leaf()) {
      if (none(cube.occupied) && (all(cube.free) || at_bound(node, model_.least))) return add(node, model_.miss);
      if (none(cube.free) && (all(cube.occupied) || at_bound(node, model_.most))) return add(node, model_.hit);
      open(node);
    }
    for (std::size_t i = 0; i < 8; ++i) {
      const Cube part = cube.child(i);
      if (!part.untouched()) update(child_of(node, i), part);
    }
    finish(node);
  }

  /// Makes room for a leaf's children: of a new node there are none yet, of any other all, like it.
  void open(const Node& node) { node.children() = supply_.take(node.is_new ? NodeBlock::kNoNode : node.log_odds()); }

  /// A child of a node that has been opened.
  Node child_of(const Node& node, std::size_t i) {
    NodeBlock& block = blocks_[node.children()];
    const bool is_new = !block.has(i);
    if (is_new) block.log_odds[i] = 0.0f;
    return {&block, i, is_new};
  }

  /// The place of a child that may not be there.
  Node place_of(const Node& node, std::size_t i) { return {&blocks_[node.children()], i, false}; }

  /// Prunes, or takes the most occupied child's value.
  void finish(const Node& node) {
    const NodeBlock& block = blocks_[node.children()];
    bool alike = true;
    BlockNumber any = 0;
    float most = -std::numeric_limits<float>::infinity();
    for (std::size_t i = 0; i < 8; ++i) {
      alike &= block.log_odds[i] == block.log_odds[0];
      any |= block.children[i];
      most = block.log_odds[i] > most ? block.log_odds[i] : most;
    }
    node.log_odds() = most;
    if (!alike || any != 0) return;
    supply_.give_back(node.children());
    node.children() = 0;
  }

  /// Forgets all that is below a node, and the node.
  void remove(const Node& node) {
    if (!node.is_leaf()) {
      for (std::size_t i = 0; i < 8; ++i) remove({&blocks_[node.children()], i, false});
      supply_.give_back(node.children());
    }
    node.children() = 0;
    node.log_odds() = NodeBlock::kNoNode;
  }

  /// finish(), of a node some of whose children may have been removed.
  void finish_after_removal(const Node& node) {
    const NodeBlock& block = blocks_[node.children()];
    const auto exists = [](float log_odds) { return !std::isnan(log_odds); };
    if (std::any_of(block.log_odds.begin(), block.log_odds.end(), exists)) return finish(node);
    remove(node);
  }

  /// A brick's node of which nothing is known yet, from the sweeps that touched it.
  void replay(Node node, const VoxelHistory::BrickHistory& history) {
    for (const auto& [sweep, packed] : history) {
      const VoxelBrick brick = packed.unpacked();
      if (node.is_new) node.log_odds() = 0.0f;
      update(node, {brick.free, brick.occupied});
      node.is_new = false;
    }
  }

 private:
  /// A cube of 4 voxels a side.
  void update_word(const Node& node, const SmallCube& cube) {
    constexpr std::uint64_t kAll = ~std::uint64_t{0};
    if (node.is_leaf()) {
      if (cube.occupied == 0 && (cube.free == kAll || at_bound(node, model_.least))) return add(node, model_.miss);
      if (cube.free == 0 && (cube.occupied == kAll || at_bound(node, model_.most))) return add(node, model_.hit);
      open(node);
    }
    for (std::size_t i = 0; i < 8; ++i) {
      const SmallCube part{cube.free >> 8 * i & 255, cube.occupied >> 8 * i & 255};
      if ((part.free | part.occupied) != 0) update_byte(child_of(node, i), part);
    }
    finish(node);
  }

  /// A cube of 2 voxels a side, whose children are voxels.
  void update_byte(const Node& node, const SmallCube& cube) {
    if (node.is_leaf()) {
      if (cube.occupied == 0 && (cube.free == 255 || at_bound(node, model_.least))) return add(node, model_.miss);
      if (cube.free == 0 && (cube.occupied == 255 || at_bound(node, model_.most))) return add(node, model_.hit);
      open(node);
    }
    std::array<float, 8>& values = blocks_[node.children()].log_odds;
    for (std::size_t i = 0; i < 8; ++i) {
      const float before = values[i], start = before == before ? before : 0.0f;
      const float after = model_.after(start, cube.occupied >> i & 1 ? model_.hit : model_.miss);
      values[i] = (cube.free | cube.occupied) >> i & 1 ? after : before;
    }
    finish(node);
  }

  /// Whether a leaf's value can go no further, so that it does not matter which of its voxels are touched.
  bool at_bound(const Node& node, float bound) const { return !node.is_new && node.log_odds() == bound; }

  void add(const Node& node, float change) const { node.log_odds() = model_.after(node.log_odds(), change); }

  NodeBlocks& blocks_;
  BlockSupply supply_;
  SensorModel model_;
};

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
void descend(SweepUpdate& update, const Node& at, int level, Numbers numbers, std::vector<Node>& nodes) {
  if (level == kBrickLevel) return nodes.push_back(at);
  if (at.is_leaf()) update.open(at);
  for_children(numbers, level, [&](unsigned i, Numbers of_child) {
    descend(update, update.child_of(at, i), level - 1, of_child, nodes);
  });
}

void ascend(SweepUpdate& update, const Node& node, int level, Numbers numbers) {
  if (level == kBrickLevel) return;
  for_children(numbers, level,
               [&](unsigned i, Numbers of_child) { ascend(update, update.place_of(node, i), level - 1, of_child); });
  update.finish_after_removal(node);
}

}  // namespace

LogOddsTree::LogOddsTree() {
  top_.log_odds.fill(NodeBlock::kNoNode);
  top_.children.fill(0);
}

void LogOddsTree::update(VoxelBricks& bricks) {
  const std::vector<VoxelBricks::BrickNumber> numbers = bricks.numbers();
  if (numbers.empty()) return;
  const Node root{&top_, 0, !top_.has(0)};
  if (root.is_new) root.log_odds() = 0.0f;
  SweepUpdate update(blocks_);
  std::vector<Node> nodes;
  descend(update, root, kTreeLevels, numbers, nodes);
  tbb::enumerable_thread_specific<SweepUpdate> of_thread([this] { return SweepUpdate(blocks_); });
  for_blocks(nodes.size(), kBricksInBlock, [&](std::size_t begin, std::size_t end, std::size_t) {
    SweepUpdate& part = of_thread.local();
    for (std::size_t i = begin; i < end; ++i) {
      VoxelBrick& brick = bricks.at(numbers[i]);
      brick.prefer_occupied();
      part.update(nodes[i], {brick.free, brick.occupied});
    }
  });
  ascend(update, root, kTreeLevels, numbers);
}

void LogOddsTree::remake(const std::vector<VoxelBricks::BrickNumber>& numbers, const VoxelHistory& history) {
  if (numbers.empty()) return;
  const Node root{&top_, 0, !top_.has(0)};
  if (root.is_new) root.log_odds() = 0.0f;
  SweepUpdate update(blocks_);
  std::vector<Node> nodes;
  descend(update, root, kTreeLevels, numbers, nodes);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    update.remove(nodes[i]);
    update.replay({nodes[i].block, nodes[i].child, true}, history.of(numbers[i]));
  }
  ascend(update, root, kTreeLevels, numbers);
}

}  // namespace scanway
