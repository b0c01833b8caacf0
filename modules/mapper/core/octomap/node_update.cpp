#include "modules/mapper/core/octomap/node_update.h"

#include "common/math/repeatable.h"

namespace scanway {
namespace {

using Words = std::span<const std::uint64_t>;

float log_odds(double probability) { return static_cast<float>(repeatable::log(probability / (1.0 - probability))); }

bool all(Words words) {
  return std::all_of(words.begin(), words.end(), [](std::uint64_t word) { return word == ~std::uint64_t{0}; });
}

bool none(Words words) {
  std::uint64_t any = 0;
  for (const std::uint64_t word : words) any |= word;
  return any == 0;
}

/// Gives a node the value of its most occupied child. Whether all children are there and alike.
bool take_most(const std::array<float, 8>& values, const Node& node) {
  bool alike = true;
  float most = -std::numeric_limits<float>::infinity();
  for (const float value : values) {
    alike &= value == values[0];
    most = value > most ? value : most;
  }
  node.log_odds() = most;
  return alike;
}

}  // namespace

SensorModel::SensorModel() : hit(log_odds(0.7)), miss(log_odds(0.4)), least(log_odds(0.1192)), most(log_odds(0.971)) {}

bool NodeUpdate::Cube::untouched() const { return none(free) && none(occupied); }

void NodeUpdate::update(Node& node, const VoxelBrick& brick) {
  if (node.is_new) node.log_odds() = 0.0f;
  update_cube(node, {brick.free, brick.occupied});
  node.is_new = false;
}

void NodeUpdate::update_cube(const Node& node, const Cube& cube) {
  if (cube.free.size() == 1) return update_word(node, {cube.free[0], cube.occupied[0]});
  if (node.is_leaf()) {
    if (none(cube.occupied) && (all(cube.free) || at_bound(node, model_.least))) return add(node, model_.miss);
    if (none(cube.free) && (all(cube.occupied) || at_bound(node, model_.most))) return add(node, model_.hit);
    open(node);
  }
  for (std::size_t i = 0; i < 8; ++i) {
    const Cube part = cube.child(i);
    if (!part.untouched()) update_cube(child_of(node, i), part);
  }
  finish(node);
}

/// A cube of 4 voxels a side.
void NodeUpdate::update_word(const Node& node, const SmallCube& cube) {
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
void NodeUpdate::update_byte(const Node& node, const SmallCube& cube) {
  if (node.is_leaf()) {
    if (cube.occupied == 0 && (cube.free == 255 || at_bound(node, model_.least))) return add(node, model_.miss);
    if (cube.free == 0 && (cube.occupied == 255 || at_bound(node, model_.most))) return add(node, model_.hit);
  }
  VoxelBlock voxels = voxels_of(node);
  for (std::size_t i = 0; i < 8; ++i) {
    const float before = voxels.log_odds[i], start = before == before ? before : 0.0f;
    const float after = model_.after(start, cube.occupied >> i & 1 ? model_.hit : model_.miss);
    voxels.log_odds[i] = (cube.free | cube.occupied) >> i & 1 ? after : before;
  }
  finish(node, voxels);
}

/// As they are, or those of a leaf.
VoxelBlock NodeUpdate::voxels_of(const Node& node) const {
  if (!node.is_leaf()) return voxels_[node.children()];
  VoxelBlock voxels;
  voxels.log_odds.fill(value_of_children(node));
  return voxels;
}

Node NodeUpdate::child_of(const Node& node, std::size_t i) {
  NodeBlock& block = nodes_[node.children()];
  const bool is_new = !block.has(i);
  if (is_new) block.log_odds[i] = 0.0f;
  return {&block, i, is_new};
}

void NodeUpdate::finish(const Node& node) {
  const NodeBlock& block = nodes_[node.children()];
  BlockNumber any = 0;
  for (const BlockNumber children : block.children) any |= children;
  if (!take_most(block.log_odds, node) || any != 0) return;
  node_supply_.give_back(node.children());
  node.children() = 0;
}

void NodeUpdate::finish(const Node& node, const VoxelBlock& voxels) {
  if (!take_most(voxels.log_odds, node)) return (void)(node.children() = voxel_supply_.put(node.children(), voxels));
  if (!node.is_leaf()) voxel_supply_.give_back(node.children());
  node.children() = 0;
}

void NodeUpdate::finish_or_remove(const Node& node) {
  const NodeBlock& block = nodes_[node.children()];
  const auto exists = [](float value) { return !std::isnan(value); };
  if (std::any_of(block.log_odds.begin(), block.log_odds.end(), exists)) return finish(node);
  node_supply_.give_back(node.children());
  node.children() = 0;
  node.log_odds() = kNoNode;
}

void NodeUpdate::remove(const Node& node, int level) {
  if (!node.is_leaf() && level == 1) voxel_supply_.give_back(node.children());
  if (!node.is_leaf() && level > 1) {
    for (std::size_t i = 0; i < 8; ++i) remove(place_of(node, i), level - 1);
    node_supply_.give_back(node.children());
  }
  node.children() = 0;
  node.log_odds() = kNoNode;
}

}  // namespace scanway
