#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <locale>
#include <sstream>
#include <string_view>

#include "modules/mapper/core/octomap/log_odds_tree.h"

namespace scanway {
namespace {

std::string header(const char* first_line, std::size_t nodes, double resolution_m) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << first_line << "\n# (feel free to add / change comments, but leave the first line as it is!)\n#\n"
       << "id OcTree\nsize " << nodes << "\nres " << resolution_m << "\ndata\n";
  return text.str();
}

/// Bytes on their way to whoever takes them, some at a time.
class Parts {
 public:
  explicit Parts(const TakeBytes& take) : take_(take) {}

  void put(std::string_view bytes) {
    part_.append(bytes);
    if (part_.size() >= kPart) pass_on();
  }
  void pass_on() {
    take_(part_);
    part_.clear();
  }

 private:
  static constexpr std::size_t kPart = std::size_t{1} << 16;

  const TakeBytes& take_;
  std::string part_;
};

/// A node's value, and a bit for each child that it has.
void put_node(float log_odds, unsigned children, Parts& parts) {
  std::array<char, sizeof(float) + 1> bytes{};
  std::memcpy(bytes.data(), &log_odds, sizeof(float));
  bytes.back() = static_cast<char>(children);
  parts.put({bytes.data(), bytes.size()});
}

template <class Block>
unsigned present_in(const Block& block) {
  unsigned present = 0;
  for (std::size_t i = 0; i < 8; ++i) present |= static_cast<unsigned>(block.has(i)) << i;
  return present;
}

/// Parents first.
void write_values(const TreeBlocks& blocks, const NodeBlock& block, std::size_t child, int level, Parts& parts) {
  const float value = block.log_odds[child];
  const BlockNumber number = block.children[child];
  if (number == 0) return put_node(value, 0, parts);
  if (level == 1) {
    const VoxelBlock voxels = blocks.voxels[number];
    put_node(value, present_in(voxels), parts);
    for (std::size_t i = 0; i < 8; ++i) {
      if (voxels.has(i)) put_node(voxels.log_odds[i], 0, parts);
    }
    return;
  }
  const NodeBlock& nodes = blocks.nodes[number];
  put_node(value, present_in(nodes), parts);
  for (std::size_t i = 0; i < 8; ++i) {
    if (nodes.has(i)) write_values(blocks, nodes, i, level - 1, parts);
  }
}

void count(const TreeBlocks& blocks, const NodeBlock& block, std::size_t child, int level, LogOddsTree::Size& size) {
  ++size.nodes;
  const BlockNumber number = block.children[child];
  if (number == 0) return (void)++size.leaves;
  if (level == 1) {
    const auto voxels = static_cast<std::size_t>(std::popcount(present_in(blocks.voxels[number])));
    size.nodes += voxels;
    size.leaves += voxels;
    return;
  }
  const NodeBlock& nodes = blocks.nodes[number];
  for (std::size_t i = 0; i < 8; ++i) {
    if (nodes.has(i)) count(blocks, nodes, i, level - 1, size);
  }
}

/// The most likely states of a tree, pruned as OcTreeBaseImpl::prune() does: from the deepest level upwards, until
/// there is one that has nothing to prune; the root stays.
class MostLikely {
 public:
  MostLikely(const TreeBlocks& blocks, const NodeBlock& top) : blocks_(blocks) {
    state(top, 0, 0);
    while (last_pruned_ > 1 && pruned_[static_cast<std::size_t>(last_pruned_) - 1] > 0) --last_pruned_;
    write(top, 0, 0);
  }

  std::string data;       ///< Of each node with children, parents first, its children's states in two bits each.
  std::size_t nodes = 0;  ///< After pruning.

 private:
  enum State : unsigned { unknown = 0, free = 1, occupied = 2, inner = 3 };

  static State of_leaf(float log_odds) { return log_odds >= 0.0f ? occupied : free; }

  /// The state of a node if every level were pruned; counts what is pruned on each.
  State state(const NodeBlock& block, std::size_t child, std::size_t depth) {
    if (block.children[child] == 0) return of_leaf(block.log_odds[child]);
    const auto states = states_below(block.children[child], depth, [&](const NodeBlock& children, std::size_t i) {
      return state(children, i, depth + 1);
    });
    if (!alike(states)) return inner;
    ++pruned_[depth];
    return states[0];
  }

  /// Of a node's children; `of_node` of those that may have children of their own.
  template <class OfNode>
  std::array<State, 8> states_below(BlockNumber number, std::size_t depth, const OfNode& of_node) const {
    if (depth + 1 == kTreeLevels) return states_of(blocks_.voxels[number]);
    std::array<State, 8> states{};
    const NodeBlock& children = blocks_.nodes[number];
    for (std::size_t i = 0; i < 8; ++i) {
      if (children.has(i)) states[i] = of_node(children, i);
    }
    return states;
  }

  static std::array<State, 8> states_of(const VoxelBlock& voxels) {
    std::array<State, 8> states{};
    for (std::size_t i = 0; i < 8; ++i) {
      if (voxels.has(i)) states[i] = of_leaf(voxels.log_odds[i]);
    }
    return states;
  }

  static bool alike(const std::array<State, 8>& states) {
    return (states[0] == free || states[0] == occupied) &&
           std::all_of(states.begin(), states.end(), [&](State state) { return state == states[0]; });
  }

  /// The same, with the levels that are pruned, writing; what a pruned node's children wrote is taken back.
  State write(const NodeBlock& block, std::size_t child, std::size_t depth) {
    ++nodes;
    if (block.children[child] == 0 && depth > 0) return of_leaf(block.log_odds[child]);
    const std::size_t at = data.size(), nodes_before = nodes;
    data.resize(at + 2);
    if (block.children[child] == 0) return inner;  // a root alone
    const auto states = states_below(block.children[child], depth, [&](const NodeBlock& children, std::size_t i) {
      return write(children, i, depth + 1);
    });
    if (depth + 1 == kTreeLevels)
      nodes += 8 - static_cast<std::size_t>(std::count(states.begin(), states.end(), unknown));
    if (static_cast<int>(depth) >= last_pruned_ && alike(states)) {
      data.resize(at);
      nodes = nodes_before;
      return states[0];
    }
    unsigned bits = 0;
    for (std::size_t i = 0; i < 8; ++i) bits |= states[i] << (2 * i);
    data[at] = static_cast<char>(bits & 255);
    data[at + 1] = static_cast<char>(bits >> 8);
    return inner;
  }

  const TreeBlocks& blocks_;
  std::array<std::size_t, kTreeLevels> pruned_{};  ///< By depth.
  int last_pruned_ = kTreeLevels;                  ///< The least depth that is pruned.
};

}  // namespace

LogOddsTree::Size LogOddsTree::size() const {
  Size size;
  if (top_.has(0)) count(blocks_, top_, 0, kTreeLevels, size);
  return size;
}

void LogOddsTree::write_ot(double resolution_m, const TakeBytes& take) const {
  Parts parts(take);
  parts.put(header("# Octomap OcTree file", size().nodes, resolution_m));
  if (top_.has(0)) write_values(blocks_, top_, 0, kTreeLevels, parts);
  parts.pass_on();
}

std::string LogOddsTree::bt_bytes(double resolution_m) const {
  constexpr const char* kFirstLine = "# Octomap OcTree binary file";
  if (!top_.has(0)) return header(kFirstLine, 0, resolution_m);
  const MostLikely tree(blocks_, top_);
  return header(kFirstLine, tree.nodes, resolution_m) + tree.data;
}

}  // namespace scanway
