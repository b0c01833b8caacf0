#pragma once

#include <array>
#include <cstdint>

#include "modules/planner/core/body/body.h"

namespace scanway::planning {

/// A place of the body: a roomy cell by its index, or a tight cell at one heading, numbered from the frame's size on.
using Node = std::uint32_t;

/// How a node hangs on its parent, in six bits: the step to the parent's cell, and which of its nodes it is.
using Link = std::uint8_t;
constexpr Link kLinkMask = 0x3F;

/// Which of the parent cell's nodes it is. From kRoomyParent + 1 on, for a roomy child of a tight parent: the match
/// (below) of the parent's heading.
enum LinkCode : unsigned { kRoomyParent = 0, kSameHeading = 1, kTurnFromBelow = 2, kTurnFromAbove = 3 };

constexpr Link link_of(int step_to_parent, unsigned code) {
  return static_cast<Link>(static_cast<unsigned>(step_to_parent) | code << 3);
}

constexpr int kMatches = 6;  ///< Headings that go with a step: three forwards, then three backwards.
constexpr int match(int step, int k) { return (2 * step + k % 3 - 1 + 8 * (k / 3)) & (kHeadings - 1); }
/// The inverse of match(); -1 when the heading does not go with the step.
constexpr int match_of(int step, int heading) {
  constexpr std::array<std::int8_t, kHeadings> kMatch = {1, 2, -1, -1, -1, -1, -1, 3, 4, 5, -1, -1, -1, -1, -1, 0};
  return kMatch[static_cast<std::size_t>((heading - 2 * step) & (kHeadings - 1))];
}

}  // namespace scanway::planning
