#include "modules/mapper/core/ground/ground_surface.h"

#include <cmath>

#include <gtest/gtest.h>

#include "common/random/random.h"

namespace scanway {
namespace {

/// Floor points on a grid, at the height that `height(x, y)` gives, seen from 1.2 m above the origin.
template <class Height>
MapPoints floor_of(double extent, double spacing, double noise, const Height& height) {
  Random random(4);
  MapPoints points;
  points.origin = {0.0, 0.0, 1.2};
  for (double y = -extent; y < extent; y += spacing) {
    for (double x = -extent; x < extent; x += spacing) {
      points.points.push_back(Eigen::Vector3d(x, y, height(x, y) + noise * random.normal()).cast<float>());
    }
  }
  return points;
}

GroundSurface surface_of(const MapPoints& points) { return {points, GroundPlane{}, GroundSurfaceConfig{}}; }

TEST(GroundSurface, FollowsAnUnevenFloor) {
  const auto height = [](double x, double y) { return 0.03 * std::sin(x) + 0.03 * std::cos(0.7 * y) - 0.03; };
  for (const double spacing : {0.02, 0.1}) {
    const GroundSurface surface = surface_of(floor_of(5.0, spacing, 0.002, height));
    for (double y = -4.5; y < 4.5; y += 0.37) {
      for (double x = -4.5; x < 4.5; x += 0.41) {
        EXPECT_TRUE(surface.carried(x, y)) << x << " " << y;
        EXPECT_NEAR(surface.height_at(x, y), height(x, y), 0.006);
      }
    }
  }
}

TEST(GroundSurface, ClimbsWhatTheRobotClimbsAndNotMore) {
  const auto step = [](double h) { return [h](double x, double) { return x > 1.0 ? h : 0.0; }; };
  const GroundSurface low = surface_of(floor_of(4.0, 0.02, 0.003, step(0.02)));
  EXPECT_TRUE(low.carried(2.0, 0.0));
  EXPECT_NEAR(low.height_at(2.0, 0.0), 0.02, 0.002);
  for (const double h : {0.05, 0.12, 0.75, -0.05, -0.2}) {
    const GroundSurface high = surface_of(floor_of(4.0, 0.02, 0.003, step(h)));
    EXPECT_TRUE(high.carried(0.5, 0.0)) << h;
    EXPECT_FALSE(high.carried(2.0, 0.0)) << h;
  }
}

TEST(GroundSurface, WalksUpARampOntoWhatItLeadsTo) {
  // a dock of 0.3 m with a ramp of 8.5 degrees on one side
  const auto height = [](double x, double y) {
    if (x < 1.0) return 0.0;
    return y < 0.0 ? std::min((x - 1.0) * 0.15, 0.3) : 0.3;
  };
  const GroundSurface surface = surface_of(floor_of(5.0, 0.05, 0.003, height));
  EXPECT_TRUE(surface.carried(2.0, -2.0));
  EXPECT_NEAR(surface.height_at(2.0, -2.0), 0.15, 0.01);
  EXPECT_TRUE(surface.carried(4.0, 2.0)) << "reached by the ramp";
  EXPECT_NEAR(surface.height_at(4.0, 2.0), 0.3, 0.01);
}

TEST(GroundSurface, FollowsARampOfWhichOnlySparseLinesAreSeen) {
  // 13 degrees, flush with the floor at its foot, upright at its side: lines across it, 0.3 m apart.
  const auto height = [](double x, double y) { return x > 1.0 && y > 1.0 ? (x - 1.0) * 0.23 : 0.0; };
  MapPoints points = floor_of(5.0, 0.03, 0.001, height);
  std::erase_if(points.points, [](const Eigen::Vector3f& p) {
    const float line = (p.x() - 0.4f * p.y()) / 0.3f;
    return p.y() > 1.0f && std::fabs(line - std::round(line)) > 0.08f;
  });
  const GroundSurface surface = surface_of(points);
  for (double x = -1.0; x < 4.5; x += 0.07) {
    EXPECT_TRUE(surface.carried(x, 3.0)) << x;
    EXPECT_NEAR(surface.height_at(x, 3.0), height(x, 3.0), std::fabs(x - 1.0) < 0.3 ? 0.03 : 0.01) << x;
  }
  EXPECT_NEAR(surface.height_at(3.0, 0.5), 0.0, 0.01);
}

TEST(GroundSurface, TooSteepIsNotCarried) {
  const auto slope = [](double x, double) { return x > 1.0 ? (x - 1.0) * 0.32 : 0.0; };  // 17.7 degrees
  const GroundSurface surface = surface_of(floor_of(4.0, 0.02, 0.0, slope));
  EXPECT_TRUE(surface.carried(0.0, 0.0));
  EXPECT_FALSE(surface.carried(2.0, 0.0));
}

TEST(GroundSurface, CarriesNothingFurtherThanTheReach) {
  MapPoints points = floor_of(1.0, 0.05, 0.0, [](double, double) { return 0.0; });
  const GroundSurface surface = surface_of(points);
  EXPECT_TRUE(surface.carried(1.15, 0.0));
  EXPECT_FALSE(surface.carried(1.45, 0.0));
  EXPECT_NEAR(surface.height_at(1.45, 0.0), 0.0, 1e-3);
}

/// A slab of 3 x 2.5 m behind a gap in the floor, its low edge 6 cm over the floor, leaning so much.
MapPoints floor_with_slab(double lean) {
  const auto on_slab = [](double x, double y) { return x > 2.0 && x < 4.5 && std::fabs(y) < 1.5; };
  MapPoints points =
      floor_of(6.0, 0.05, 0.001, [&](double x, double y) { return on_slab(x, y) ? 0.06 + lean * (x - 2.0) : 0.0; });
  std::erase_if(points.points, [](const Eigen::Vector3f& p) { return p.x() > 1.0f && p.x() < 2.0f; });
  return points;
}

TEST(GroundSurface, WhatLeansOnTheGroundIsAThing) {
  GroundSurfaceConfig config;
  config.least_level_m2 = 2.0;
  const GroundSurface level(floor_with_slab(0.0), GroundPlane{}, config);
  EXPECT_TRUE(level.carried(3.0, 0.0)) << "a pavement";
  EXPECT_NEAR(level.height_at(3.0, 0.0), 0.06, 0.01);
  for (const double lean : {0.12, 0.2}) {
    const GroundSurface leaning(floor_with_slab(lean), GroundPlane{}, config);
    EXPECT_FALSE(leaning.carried(3.0, 0.0)) << lean;
    EXPECT_TRUE(leaning.carried(5.5, 0.0)) << lean;
  }
}

TEST(GroundSurface, AKerbLowerThanTheBandIsWideIsNoSlope) {
  const GroundSurface surface =
      surface_of(floor_of(4.0, 0.05, 0.001, [](double x, double) { return x > 1.0 ? 0.05 : 0.0; }));
  for (double x = 0.5; x < 0.95; x += 0.05) EXPECT_NEAR(surface.height_at(x, 0.0), 0.0, 0.01) << x;
}

TEST(GroundSurface, FloorBeyondAGapJoinsAtItsHeight) {
  const auto with_gap = [](double island) {
    MapPoints points = floor_of(4.0, 0.05, 0.0, [island](double x, double) { return x > 2.0 ? island : 0.0; });
    std::erase_if(points.points, [](const Eigen::Vector3f& p) { return p.x() > 1.0f && p.x() < 2.0f; });
    return points;
  };
  EXPECT_TRUE(surface_of(with_gap(0.01)).carried(3.0, 0.0));
  EXPECT_FALSE(surface_of(with_gap(0.08)).carried(3.0, 0.0));
}

}  // namespace
}  // namespace scanway
