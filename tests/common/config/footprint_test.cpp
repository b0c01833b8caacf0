#include "common/config/footprint.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "common/random/random.h"

namespace scanway {
namespace {

using Corners = std::vector<Eigen::Vector2d>;

/// Counter-clockwise around the centre, at growing angles: simple, whatever the radii.
Corners star(Random& random) {
  const auto n = 5 + random.below(20);
  Corners corners;
  for (std::uint64_t i = 0; i < n; ++i) {
    const double angle = 2 * M_PI * (static_cast<double>(i) + 0.5 * random.uniform()) / static_cast<double>(n);
    const double radius = 0.2 + 3 * random.uniform();
    corners.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return corners;
}

TEST(Footprint, AcceptsEveryStarAboutTheCentreAndNoneOfItsDistortions) {
  Random random(3);
  for (int round = 0; round < 2000; ++round) {
    const Corners corners = star(random);
    ASSERT_EQ(footprint_problem(corners), "");
    Corners turned = corners;
    std::ranges::reverse(turned);
    EXPECT_NE(footprint_problem(turned).find("clockwise"), std::string::npos);
    Corners moved = corners;
    for (auto& corner : moved) corner.x() += 4;
    EXPECT_NE(footprint_problem(moved).find("centre"), std::string::npos);
    Corners crossed = corners;
    for (auto& corner : crossed) corner.normalize();  // convex now: any swap crosses two edges
    std::swap(crossed[1], crossed[3]);
    EXPECT_NE(footprint_problem(crossed), "");
  }
}

TEST(Footprint, RefusesWhatTouchesItself) {
  EXPECT_NE(footprint_problem({{1, 1}, {-1, 1}, {-1, -1}, {1, -1}, {-1, 0.5}}), "");  // a corner on an edge
  EXPECT_NE(footprint_problem({{1, 0}, {-1, 1}, {-3, 2}, {-1, 1}, {-1, -1}}), "");    // a spike
  EXPECT_NE(footprint_problem({{1, 0}, {0, 0}, {-1, 0}}), "");                        // no area
  EXPECT_NE(footprint_problem({{NAN, 1}, {-1, 1}, {-1, -1}}), "");
  EXPECT_EQ(footprint_problem({{1, 1}, {0, 1}, {-1, 1}, {-1, -1}, {1, -1}}), "");  // a corner along an edge is fine
}

}  // namespace
}  // namespace scanway
