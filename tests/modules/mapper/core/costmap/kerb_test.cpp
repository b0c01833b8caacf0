// What hides ground, and what does not.
#include <cmath>

#include <gtest/gtest.h>

#include "modules/mapper/core/map.h"
#include "tests/modules/mapper/core/costmap/scene.h"

namespace scanway::testing {
namespace {

const Eigen::Vector3d kLowSensor(0.0, 0.0, 0.53);

/// Of the cells of a rectangle, how many the map calls free after one sweep, in percent.
int percent_free(const Scene& scene, const Eigen::Vector3d& sensor, const Eigen::Vector2d& low,
                 const Eigen::Vector2d& high) {
  Map map(Robot{}, 1);
  map.merge(scan(scene, sensor, 0.12, 0.1667, 0.01, 3), Pose::Identity());
  int cells = 0, free = 0;
  for (double y = low.y() + 0.005; y < high.y(); y += 0.01) {
    for (double x = low.x() + 0.005; x < high.x(); x += 0.01) {
      ++cells;
      free += map.cost_map().state(Cell{static_cast<std::int32_t>(std::floor(x / 0.01)),
                                        static_cast<std::int32_t>(std::floor(y / 0.01))}) == CellState::free
                  ? 1
                  : 0;
    }
  }
  return 100 * free / cells;
}

TEST(Kerb, ItsFaceDoesNotHideItsTop) {
  const Scene island{{{{2.0, -3.0, -0.5}, {5.0, 3.0, 0.12}}}};
  EXPECT_GE(percent_free(island, kLowSensor, {2.1, -1.0}, {2.5, 1.0}), 97);
  EXPECT_EQ(percent_free(island, kLowSensor, {2.0, -1.0}, {2.01, 1.0}), 0);
}

TEST(Kerb, WhatIsSmallHasNoTopToStandOn) {
  const Scene box{{{{2.0, -0.3, -0.5}, {2.6, 0.3, 0.12}}}};
  EXPECT_EQ(percent_free(box, kLowSensor, {2.0, -0.3}, {2.6, 0.3}), 0);
}

TEST(BodyHigh, FloorUnderAThingAsHighAsTheBodyIsHiddenAlsoFromAbove) {
  // From a mast of 2.5 m the floor is seen below a container whose underside is 0.4 m above it.
  const Scene scene{{{{7.0, -3.0, 0.4}, {9.5, 3.0, 2.3}}}};
  EXPECT_EQ(percent_free(scene, {0.0, 0.0, 2.5}, {7.0, -1.0}, {8.3, 1.0}), 0);
}

}  // namespace
}  // namespace scanway::testing
