#include "modules/mapper/core/costmap/evidence.h"

#include <gtest/gtest.h>

namespace scanway {
namespace {

constexpr Known kAll[] = {Known::nothing, Known::suspected, Known::sparsely_free,
                          Known::free,    Known::low,       Known::occupied};

/// What becomes of a cell that was `before`.
Known seen(Known before, int beams, int ground, int returns = 0) {
  static EvidenceTile tile;
  tile.beams[7] = static_cast<std::uint8_t>(beams);
  tile.ground[7] = static_cast<std::uint8_t>(ground);
  tile.returns[7] = static_cast<std::uint8_t>(returns);
  return tile.over(before, 7);
}

TEST(EvidenceTile, ANewerViewFromNearByWins) {
  for (const Known before : kAll) {
    EXPECT_EQ(seen(before, EvidenceTile::kEmpty, 5), Known::free);
    EXPECT_EQ(seen(before, EvidenceTile::kEmpty, 5, 1), Known::occupied);
    EXPECT_EQ(seen(before, EvidenceTile::kLowStep, 5, 1), Known::low);
    EXPECT_EQ(seen(before, EvidenceTile::kDrop, 5), Known::low);
    EXPECT_EQ(seen(before, 0, 5), before);
  }
}

TEST(EvidenceTile, BeamsThatLieFarApartTakeAwayWhatTheyCannotMissAlone) {
  EXPECT_EQ(seen(Known::nothing, EvidenceTile::kSparse, 5), Known::sparsely_free);
  EXPECT_EQ(seen(Known::occupied, EvidenceTile::kSparse, 5), Known::sparsely_free);
  for (const Known before : {Known::suspected, Known::sparsely_free, Known::free, Known::low}) {
    EXPECT_EQ(seen(before, EvidenceTile::kSparse, 5), before);
  }
}

TEST(EvidenceTile, WhereTheGroundMayBreakOffNothingIsFreeUntilItIsSeenFromNearBy) {
  EXPECT_EQ(seen(Known::nothing, EvidenceTile::kUnsure, 5), Known::suspected);
  EXPECT_EQ(seen(Known::sparsely_free, EvidenceTile::kUnsure, 5), Known::suspected);
  for (const Known before : {Known::free, Known::low, Known::occupied}) {
    EXPECT_EQ(seen(before, EvidenceTile::kUnsure, 5), before);
  }
  EXPECT_EQ(state_of(Known::suspected), CellState::unknown);
}

TEST(EvidenceTile, WhatMayBeASlopeIsADropUntilItIsKnown) {
  EXPECT_EQ(seen(Known::nothing, EvidenceTile::kFarDrop, 5), Known::low);
  EXPECT_EQ(seen(Known::sparsely_free, EvidenceTile::kFarDrop, 5), Known::low);
  EXPECT_EQ(seen(Known::free, EvidenceTile::kFarDrop, 5), Known::free);
}

TEST(EvidenceTile, InItsOwnShadowTheRobotBelievesWhatItSawBefore) {
  EXPECT_EQ(state_of(seen(Known::nothing, EvidenceTile::kOwnShadow, 5)), CellState::free);
  EXPECT_EQ(seen(Known::occupied, EvidenceTile::kOwnShadow, 5), Known::occupied);
}

TEST(EvidenceTile, EmptyAirOverUnknownGroundTakesThingsAwayAndMakesNoFloor) {
  EXPECT_EQ(seen(Known::nothing, EvidenceTile::kEmpty, 0), Known::nothing);
  EXPECT_EQ(seen(Known::free, EvidenceTile::kEmpty, 0), Known::free);
  EXPECT_EQ(seen(Known::occupied, EvidenceTile::kEmpty, 0), Known::nothing);
  EXPECT_EQ(seen(Known::low, EvidenceTile::kEmpty, 0), Known::low) << "over a drop the air is always empty";
}

}  // namespace
}  // namespace scanway
