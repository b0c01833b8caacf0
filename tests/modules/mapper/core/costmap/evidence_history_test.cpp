#include "modules/mapper/core/costmap/evidence_history.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "common/random/random.h"
#include "modules/mapper/core/costmap/embodiment.h"

namespace scanway {
namespace {

/// The plain way: sweeps laid over each other one after the other.
class PlainMap {
 public:
  void apply(const SweepEvidence& evidence) {
    for (const auto& [index, tile] : evidence) {
      for (std::size_t cell = 0; cell < CostTile::kCells; ++cell) {
        if (!tile.says_anything(cell)) continue;
        Known& known = known_[index][cell];
        known = tile.over(known, cell);
        map.tiles[index].state[cell] = state_of(known);
      }
    }
  }
  CostMap map;

 private:
  std::map<Cell, std::array<Known, CostTile::kCells>> known_;
};

constexpr std::int32_t kSide = CostTile::kSide;

void count_everywhere(EvidenceTile& tile, Random& random) {
  for (std::size_t cell = 0; cell < CostTile::kCells; ++cell) {
    tile.returns[cell] = static_cast<std::uint8_t>(random.below(4) == 0 ? random.below(256) : 0);
    tile.beams[cell] = static_cast<std::uint8_t>(random.below(2));
    tile.ground[cell] = static_cast<std::uint8_t>(random.below(30));
  }
}

/// A view of some tiles: patches of free ground with some returns.
SweepEvidence random_view(Random& random) {
  SweepEvidence evidence;
  for (int patch = 0; patch < 6; ++patch) {
    const Cell index{static_cast<std::int32_t>(random.below(4)) - 2, static_cast<std::int32_t>(random.below(4)) - 2};
    EvidenceTile& tile = evidence[index];
    const std::size_t x0 = random.below(100), y0 = random.below(100);
    for (std::size_t y = y0; y < y0 + 28; ++y) {
      for (std::size_t x = x0; x < x0 + 28; ++x) {
        tile.beams[y * kSide + x] = static_cast<std::uint8_t>(random.below(3) == 0 ? 1 + random.below(7) : 1);
        tile.ground[y * kSide + x] = static_cast<std::uint8_t>(1 + x / 10);
        if (random.below(12) == 0) tile.returns[y * kSide + x] = static_cast<std::uint8_t>(1 + random.below(255));
      }
    }
  }
  evidence[{9, 9}];  // a tile of which it says nothing
  return evidence;
}

TEST(PackedEvidence, IsWithoutLoss) {
  Random random(3);
  for (int round = 0; round < 20; ++round) {
    EvidenceTile tile;
    if (round > 0) count_everywhere(tile, random);
    for (std::size_t cell = 0; round > 10 && cell < CostTile::kCells; ++cell) {
      tile.ground[cell] = static_cast<std::uint8_t>(cell / 10 % 13);
      tile.beams[cell] = tile.returns[cell] = 0;
    }
    const PackedEvidence packed(tile);
    const EvidenceTile again = packed.unpacked();
    EXPECT_EQ(again.returns, tile.returns);
    EXPECT_EQ(again.beams, tile.beams);
    EXPECT_EQ(again.ground, tile.ground);
    EXPECT_LT(packed.bytes(), round == 0 ? 500u : 100'000u);
  }
}

/// The cost map of views laid one over the other in order, with costs.
CostMap laid_over(const std::vector<SweepEvidence>& views, std::ptrdiff_t without = -1) {
  PlainMap plain;
  for (std::size_t i = 0; i < views.size(); ++i) {
    if (static_cast<std::ptrdiff_t>(i) != without) plain.apply(views[i]);
  }
  embody(plain.map, Robot{}, Embodiment::footprint);
  return plain.map;
}

TEST(EvidenceHistory, AnySweepOfTenCanBeWithdrawn) {
  Random random(5);
  std::vector<SweepEvidence> views;
  for (int i = 0; i < 10; ++i) views.push_back(random_view(random));
  for (std::size_t without = 0; without < views.size(); ++without) {
    CostMap map;
    EvidenceHistory history;
    const auto embody_touched = [&](const std::vector<Cell>& touched) {
      EXPECT_TRUE(std::is_sorted(touched.begin(), touched.end()));
      embody(map, Robot{}, Embodiment::footprint, touched);
    };
    for (std::size_t i = 0; i < views.size(); ++i) embody_touched(history.put(map, i, views[i]));
    ASSERT_TRUE(map.tiles == laid_over(views).tiles);
    embody_touched(history.withdraw(map, without));
    ASSERT_TRUE(map.tiles == laid_over(views, static_cast<std::ptrdiff_t>(without)).tiles) << without;
    EXPECT_TRUE(history.withdraw(map, without).empty());
    // And put back in its place.
    embody_touched(history.put(map, without, views[without]));
    ASSERT_TRUE(map.tiles == laid_over(views).tiles);
  }
}

TEST(EvidenceHistory, ASweepThatMovedLeavesNothingWhereItWas) {
  Random random(6);
  std::vector<SweepEvidence> views;
  for (int i = 0; i < 5; ++i) views.push_back(random_view(random));
  CostMap map;
  EvidenceHistory history;
  for (std::size_t i = 0; i < views.size(); ++i) {
    embody(map, Robot{}, Embodiment::paper, history.put(map, i, random_view(random)));
  }
  for (const std::size_t i : {3u, 0u, 4u, 2u, 1u}) {
    embody(map, Robot{}, Embodiment::paper, history.put(map, i, views[i]));
  }
  PlainMap expected;
  for (const SweepEvidence& view : views) expected.apply(view);
  embody(expected.map, Robot{}, Embodiment::paper);
  EXPECT_TRUE(map.tiles == expected.map.tiles);
}

TEST(EvidenceHistory, WithoutSweepsThereIsNoMap) {
  Random random(7);
  CostMap map;
  EvidenceHistory history;
  for (SweepNumber i = 0; i < 3; ++i) embody(map, Robot{}, Embodiment::paper, history.put(map, i, random_view(random)));
  EXPECT_GT(history.bytes(), 0u);
  for (SweepNumber i = 0; i < 3; ++i) embody(map, Robot{}, Embodiment::paper, history.withdraw(map, i));
  EXPECT_TRUE(map.tiles.empty());
  EXPECT_EQ(history.bytes(), 0u);
}

}  // namespace
}  // namespace scanway
