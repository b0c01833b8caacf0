#include "modules/mapper/core/costmap/return_spots.h"

#include <cmath>

#include <gtest/gtest.h>

namespace scanway {
namespace {

constexpr double kCell = 0.01;

Cell tile_of(int x, int y) { return CostMap::tile_of({x, y}); }

TEST(ReturnSpots, AllThatIsFreeWithinHalfTheBeamIsDoubted) {
  SweepViewConfig config;
  config.divergence = 0.02;
  const Eigen::Vector3d sensor(-3.0, 0.0, 0.5);
  const Cell returned{CostTile::kSide - 2, 1};  // near the corner of four tiles
  SweepEvidence evidence;
  for (int y = -1; y <= 1; ++y) {
    for (int x = 0; x <= 1; ++x) evidence[{x, y}].beams.fill(x == 0 ? EvidenceTile::kEmpty : EvidenceTile::kSparse);
  }
  evidence[{0, 0}].returns[CostMap::index_in_tile(returned)] = 1;
  const SweepEvidence before = evidence;
  doubt_spots(evidence, sensor, config, kCell);

  const double range = std::hypot((returned.x + 0.5) * kCell + 3.0, (returned.y + 0.5) * kCell);
  int doubted = 0;
  for (int y = -20; y < 20; ++y) {
    for (int x = CostTile::kSide - 20; x < CostTile::kSide + 20; ++x) {
      const double away = std::hypot(x - returned.x, y - returned.y) * kCell;
      const std::size_t cell = CostMap::index_in_tile({x, y});
      const bool in_spot = away <= 0.01 * range && !(x == returned.x && y == returned.y);
      const int expected = in_spot ? EvidenceTile::kUnsure : before.at(tile_of(x, y)).beams[cell];
      ASSERT_EQ(evidence.at(tile_of(x, y)).beams[cell], expected) << x << " " << y;
      doubted += in_spot ? 1 : 0;
    }
  }
  EXPECT_GT(doubted, 20);
}

TEST(ReturnSpots, WhatWasNotSeenToBeFreeStaysAsItIs) {
  SweepEvidence evidence;
  evidence[{0, 0}].beams[1] = EvidenceTile::kDrop;
  evidence[{0, 0}].returns[0] = 1;
  const SweepEvidence before = evidence;
  doubt_spots(evidence, {-8.0, 0.0, 0.5}, {}, kCell);
  EXPECT_EQ(evidence.at({0, 0}).beams, before.at({0, 0}).beams);
}

}  // namespace
}  // namespace scanway
