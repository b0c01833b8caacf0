#include "modules/mapper/core/costmap/evidence.h"

#include <gtest/gtest.h>

namespace scanway {
namespace {

using enum CellState;

/// What becomes of a cell that was `before`.
CellState seen(CellState before, int beams, int ground, int returns = 0) {
  static EvidenceTile tile;
  tile.beams[7] = static_cast<std::uint8_t>(beams);
  tile.ground[7] = static_cast<std::uint8_t>(ground);
  tile.returns[7] = static_cast<std::uint8_t>(returns);
  return tile.over(before, 7);
}

TEST(EvidenceTile, ANewerViewWins) {
  for (const CellState before : {unknown, CellState::free, occupied}) {
    EXPECT_EQ(seen(before, EvidenceTile::kEmpty, 5), CellState::free);
    EXPECT_EQ(seen(before, EvidenceTile::kEmpty, 5, 1), occupied);
    EXPECT_EQ(seen(before, EvidenceTile::kDrop, 5), occupied);
    EXPECT_EQ(seen(before, 0, 5), before);
  }
}

TEST(EvidenceTile, InItsOwnShadowTheRobotBelievesWhatItSawBefore) {
  EXPECT_EQ(seen(unknown, EvidenceTile::kOwnShadow, 5), CellState::free);
  EXPECT_EQ(seen(occupied, EvidenceTile::kOwnShadow, 5), occupied);
}

TEST(EvidenceTile, WhatMayBeASlopeIsADropUntilItIsKnown) {
  EXPECT_EQ(seen(unknown, EvidenceTile::kFarDrop, 5), occupied);
  EXPECT_EQ(seen(CellState::free, EvidenceTile::kFarDrop, 5), CellState::free);
}

TEST(EvidenceTile, EmptyAirOverUnknownGroundTakesThingsAwayAndMakesNoFloor) {
  EXPECT_EQ(seen(unknown, EvidenceTile::kEmpty, 0), unknown);
  EXPECT_EQ(seen(CellState::free, EvidenceTile::kEmpty, 0), CellState::free);
  EXPECT_EQ(seen(occupied, EvidenceTile::kEmpty, 0), unknown);
}

}  // namespace
}  // namespace scanway
