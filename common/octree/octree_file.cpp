#include "common/octree/octree_file.h"

#include <algorithm>

#include "common/octree/octree_space.h"

namespace scanway {

void OctreeFile::for_each_leaf(const std::function<void(const OctreeLeaf&)>& visit) const {
  visit_below(0, octree::kWhole, visit);
}

void OctreeFile::visit_below(std::int32_t node, const OctreeLeaf& cube,
                             const std::function<void(const OctreeLeaf&)>& visit) const {
  for (int child = 0; child < 8; ++child) {
    const std::int32_t below = nodes_[static_cast<std::size_t>(node)].below[static_cast<std::size_t>(child)];
    OctreeLeaf part = octree::part_of(cube, child);
    part.occupied = below == kOccupied;
    if (below >= 0) visit_below(below, part, visit);
    if (below == kFree || below == kOccupied) visit(part);
  }
}

std::int32_t OctreeFile::state_below(std::int32_t child) const {
  if (child < 0) return child;
  std::int32_t state = kUnknown;
  for (const std::int32_t below : nodes_[static_cast<std::size_t>(child)].below) {
    state = std::min(state, state_below(below));  // Occupied goes before free, free before unknown.
  }
  return state;
}

/// What `child` of `from` is here, with so many levels below it. Eight leaves that are alike are one.
std::int32_t OctreeFile::take_over(const OctreeFile& from, std::int32_t child, int levels) {
  if (child < 0 || levels == 0) return from.state_below(child);
  const auto index = static_cast<std::int32_t>(nodes_.size());
  nodes_.emplace_back();
  Inner inner;
  for (std::size_t i = 0; i < 8; ++i) {
    inner.below[i] = take_over(from, from.nodes_[static_cast<std::size_t>(child)].below[i], levels - 1);
  }
  const bool alike = std::all_of(inner.below.begin(), inner.below.end(),
                                 [&](std::int32_t below) { return below == inner.below[0] && below < 0; });
  if (alike) {
    nodes_.resize(static_cast<std::size_t>(index));
    return inner.below[0];
  }
  nodes_[static_cast<std::size_t>(index)] = inner;
  return index;
}

OctreeFile OctreeFile::coarsened(double voxel_m) const {
  int levels = octree::kDepth;
  for (double edge = 2.0 * resolution_m_; edge <= voxel_m * (1.0 + 1e-9) && levels > 1; edge *= 2.0) --levels;
  OctreeFile coarse(resolution_m_);
  for (std::size_t i = 0; i < 8; ++i) {
    const std::int32_t below = coarse.take_over(*this, nodes_[0].below[i], levels - 1);
    coarse.nodes_[0].below[i] = below;
  }
  return coarse;
}

void OctreeFile::join(const OctreeFile& cube) {
  const std::function<std::int32_t(std::int32_t, std::int32_t)> joined = [&](std::int32_t mine, std::int32_t other) {
    if (mine < 0 && mine != kUnknown) return mine;
    if (other < 0) return mine == kUnknown ? other : mine;
    if (mine == kUnknown) return take_over(cube, other, octree::kDepth);
    for (std::size_t i = 0; i < 8; ++i) {
      const std::int32_t below = joined(nodes_[static_cast<std::size_t>(mine)].below[i],
                                        cube.nodes_[static_cast<std::size_t>(other)].below[i]);
      nodes_[static_cast<std::size_t>(mine)].below[i] = below;
    }
    return mine;
  };
  joined(0, 0);
}

}  // namespace scanway
